"""What went into the built files: libraries that they link, static archives, headers, scripts of pages.

Nothing is listed by hand. The libraries are those that the files name, headers and archives those that the build used.
"""

import collections
import json
import os
import pathlib
import re
import subprocess
import tempfile

LIBRARY = "lib/libopal.so"
OBJECT = re.compile(r"^\S+\.(o|gch)$")


def told_by(*command):
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout


def needed(file):
    """The libraries that an ELF file names."""
    return re.findall(r"\(NEEDED\).*\[(.+)\]", told_by("readelf", "-d", str(file)))


def is_elf(path):
    with open(path, "rb") as file:
        return file.read(4) == b"\x7fELF"


def elf_files(folder):
    return [path for path in sorted(folder.rglob("*")) if path.is_file() and not path.is_symlink() and is_elf(path)]


def library_paths():
    """The file of each library that the loader finds."""
    return dict(re.findall(r"^\s+(\S+) \(.*\) => (\S+)$", told_by("/sbin/ldconfig", "-p"), re.MULTILINE)[::-1])


class Build:
    """A folder that ninja has built in."""

    def __init__(self, folder):
        self.folder = pathlib.Path(folder)
        self.headers = self.read_headers()
        self.of_library = set(self.inputs(LIBRARY))

    def read_headers(self):
        """The files outside the tree that each object was compiled of."""
        headers, name = collections.defaultdict(set), None
        for line in told_by("ninja", "-C", str(self.folder), "-t", "deps").splitlines():
            if line.startswith("    /usr/"):
                headers[name].add(os.path.normpath(line.strip()))
            elif ": #deps" in line:
                name = line.partition(":")[0]
        return headers

    def inputs(self, target):
        return told_by("ninja", "-C", str(self.folder), "-t", "inputs", target).splitlines()

    def parts_of(self, target):
        """What is in the file `target`, but for what is in libopal.so: static archives, headers, rooms with scripts of pages."""
        inputs = [path for path in self.inputs(target) if target == LIBRARY or path not in self.of_library or path.endswith(".gch")]
        archives = {os.path.normpath(path) for path in inputs if path.startswith("/usr/") and path.endswith(".a")}
        headers = set().union(*(self.headers[path] for path in inputs if OBJECT.match(path)))
        rooms = {found[1] for path in inputs if (found := re.search(r"(\w+)_page_assets\.cpp\.o$", path))}
        return archives, headers, rooms

    def scripts_of(self, room):
        """The files outside the tree that the script of a page is made of."""
        cache = (self.folder / "CMakeCache.txt").read_text()
        place = dict(re.findall(r"^(D3_FOLDER|DYGRAPHS_FOLDER):PATH=(.+)$", cache, re.MULTILINE))
        with tempfile.TemporaryDirectory() as folder:
            report = pathlib.Path(folder) / "parts.json"
            subprocess.run(["esbuild", f"framework/{room}/page/main.js", "--bundle", f"--metafile={report}", f"--outfile={folder}/page.js",
                            f"--alias:dygraphs={place['DYGRAPHS_FOLDER']}/dygraph.min.js", "--log-level=warning"],
                           env={**os.environ, "NODE_PATH": place["D3_FOLDER"]}, check=True)
            inputs = json.loads(report.read_text())["inputs"]
        return {path for path in map(os.path.abspath, inputs) if path.startswith("/usr/")}

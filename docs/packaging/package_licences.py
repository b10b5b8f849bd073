"""What Debian knows of the packages on this machine: which one a file belongs to, its version, and its licences."""

import functools
import os
import pathlib
import re
import subprocess

INFO = pathlib.Path("/var/lib/dpkg/info")
# Names in copyright files of Debian, and the names that SPDX gives to the same licences.
SPDX = {"apache-2.0": "Apache-2.0", "apache-2": "Apache-2.0", "bsd-2-clause": "BSD-2-Clause", "bsd-3-clause": "BSD-3-Clause",
        "boost-1.0": "BSL-1.0", "bsl-1.0": "BSL-1.0", "curl": "curl", "epl-2.0": "EPL-2.0", "expat": "MIT", "mit": "MIT",
        "gpl-2": "GPL-2.0-only", "gpl-2+": "GPL-2.0-or-later", "gpl-3": "GPL-3.0-only", "gpl-3+": "GPL-3.0-or-later",
        "isc": "ISC", "lgpl-2": "LGPL-2.0-only", "lgpl-2+": "LGPL-2.0-or-later", "lgpl-2.1": "LGPL-2.1-only",
        "lgpl-2.1+": "LGPL-2.1-or-later", "lgpl-3": "LGPL-3.0-only", "lgpl-3+": "LGPL-3.0-or-later", "mpl-1.1": "MPL-1.1",
        "mpl-2.0": "MPL-2.0", "mpl-2": "MPL-2.0", "postgresql": "PostgreSQL", "psf-2": "PSF-2.0", "zlib": "Zlib"}


@functools.cache
def real_folder(folder):
    return str(pathlib.Path(folder).resolve())


def real_path(path):
    """/lib and /usr/lib are one folder, and dpkg knows its files by either name."""
    folder, _, name = path.rpartition("/")
    return f"{real_folder(folder)}/{name}"


def owners(paths):
    """The package of each path, without its architecture. Files of no package are left out."""
    wanted = {real_path(path): path for path in paths}
    names = {path.rpartition("/")[2] for path in wanted}
    found = {}
    for listing in sorted(INFO.glob("*.list")):
        for line in listing.read_text().splitlines():
            if line.rpartition("/")[2] in names and (path := wanted.get(real_path(line))):
                found[path] = listing.stem.partition(":")[0]
    return found


def named_for_library(soname, owner):
    """The package that Debian's packages depend on for a library. Several have BLAS, and one of them goes by its name."""
    name, _, version = soname.partition(".so.")
    for listing in sorted(INFO.glob(f"{owner}[:.]*shlibs")):
        for words in map(str.split, listing.read_text().splitlines()):
            if words[:2] == [name, version] and installed(words[2]):
                return words[2]
    return owner


def owners_of_libraries(places):
    """@param places  the file of each library; it may lead to the one that /etc/alternatives names."""
    behind = {soname: os.path.realpath(path) for soname, path in places.items()}
    found = owners([*places.values(), *behind.values()])
    owner = {soname: found.get(path) or found.get(behind[soname]) for soname, path in places.items()}
    return {soname: named_for_library(soname, package) for soname, package in owner.items() if package}


def installed(package):
    return any(INFO.glob(f"{package}[:.]*list"))


@functools.cache
def version_of(package):
    told = subprocess.run(["dpkg-query", "-W", "-f", "${Version}\n", package], capture_output=True, text=True, check=True)
    return told.stdout.split()[0]


def copyright_file(package):
    return pathlib.Path("/usr/share/doc") / package / "copyright"


def licence_names(package):
    """The names in the paragraphs of files, without those of Debian's own files; empty if the file is free text."""
    file = copyright_file(package)
    names = []
    for paragraph in re.split(r"\n\s*\n", file.read_text(errors="replace") if file.is_file() else ""):
        files = re.search(r"^Files:\s*(.*)$", paragraph, re.MULTILINE)
        licence = re.search(r"^License:\s*(.+)$", paragraph, re.MULTILINE)
        if files and licence and not files[1].startswith("debian/") and licence[1].strip() not in names:
            names.append(licence[1].strip())
    return names


def spdx_expression(name):
    """None if SPDX has no name for a part of it."""
    parts = re.split(r"(?i)\s*,?\s+(or|and)\s+", name)
    words = [part.upper() if part.lower() in ("or", "and") else SPDX.get(part.lower()) for part in parts]
    return None if None in words else " ".join(words) if len(words) == 1 else "(" + " ".join(words) + ")"


def licences(package):
    """@return  an expression of SPDX or NOASSERTION, and the names that Debian's copyright file has."""
    names = licence_names(package)
    expressions = [spdx_expression(name) for name in names]
    if not names or None in expressions:
        return "NOASSERTION", names
    return " AND ".join(dict.fromkeys(expressions)), names

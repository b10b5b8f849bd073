"""Rules of size and of names: small folders, files and functions; no file for leftovers."""

import re

from functions import functions_of
from source_tree import SOURCES, WrongTable, files_below, lines_of_table, sources_below

MOST = {"folder": 25, "file": 300, "function": 40}
FOLDERS = ("framework", "plugins", "patterns", "tests")
PROGRAMS = SOURCES + (".js", ".css", ".html", ".py", ".sh")
NOT_COUNTED = ("README.md", "CMakeLists.txt")
LEFTOVERS = re.compile(r"(^|_)(utils?|helpers?|misc)$")
MANAGER = re.compile(r"\b(?:class|struct)\s+(\w+Manager)\b")


class Exceptions:
    """exceptions.txt: KIND PATH [FUNCTION] MOST: reason."""

    def __init__(self, path):
        self.path, self.allowed, self.used = path, {}, set()
        for number, line in lines_of_table(path):
            found = re.fullmatch(r"(folder|file|function) (\S+) (?:(\S+) )?(\d+): (.+)", line)
            if not found or (found[1] == "function") != bool(found[3]):
                raise WrongTable(f"{path}:{number}: expected 'folder|file PATH MOST: reason' or 'function FILE NAME MOST: reason'")
            self.allowed[found[1], found[2], found[3]] = (number, int(found[4]))

    def most(self, kind, path, name=None):
        number, most = self.allowed.get((kind, path, name), (None, MOST[kind]))
        self.used.add(number)
        return most

    def unused(self):
        for number, _ in self.allowed.values():
            if number not in self.used:
                yield self.path, number, "excuses nothing that is too large any more: remove it"


def breaks(root, exceptions_path):
    exceptions = Exceptions(exceptions_path)
    yield from folders(root, exceptions)
    yield from files(root, exceptions)
    yield from functions(root, exceptions)
    yield from exceptions.unused()
    yield from names(root)


def folders(root, exceptions):
    held = {}
    for path in files_below(root, "framework"):
        if path.name not in NOT_COUNTED:
            held.setdefault(path.parent, []).append(path)
    for folder, paths in held.items():
        below = folder.relative_to(root).as_posix()
        if len(paths) > MOST["folder"] and len(paths) > exceptions.most("folder", below):
            yield folder, 1, f"holds {len(paths)} source files, expected {MOST['folder']} at most: look for a second concern"


def files(root, exceptions):
    for folder in FOLDERS:
        for path in files_below(root, folder):
            if path.suffix not in PROGRAMS:
                continue
            lines = path.read_text().count("\n")
            if lines > MOST["file"] and lines > exceptions.most("file", path.relative_to(root).as_posix()):
                yield path, lines, f"has {lines} lines, expected {MOST['file']} at most: look for a second concept"


def functions(root, exceptions):
    for path in sources_below(root, *FOLDERS):
        below = path.relative_to(root).as_posix()
        for function in functions_of(path.read_text()):
            lines = function.last_line - function.first_line + 1
            if lines > MOST["function"] and lines > exceptions.most("function", below, function.name):
                yield path, function.first_line, (f"{function.name} has {lines} lines, expected {MOST['function']} at most")


def names(root):
    for folder in FOLDERS:
        for path in files_below(root, folder):
            if LEFTOVERS.search(path.stem) or LEFTOVERS.search(path.parent.name):
                yield path, 1, "is a place for leftovers: a function lives with the type that it serves"
    for path in sources_below(root, *FOLDERS):
        for number, line in enumerate(path.read_text().splitlines(), 1):
            found = MANAGER.search(line)
            if found:
                yield path, number, f"{found[1]}: name what it does instead"

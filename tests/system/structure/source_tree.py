"""The files of the tree, the table of rooms, and the include lines: what the checks of the structure read."""

import collections
import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parents[3]
HERE = pathlib.Path(__file__).resolve().parent
SOURCES = (".cpp", ".hpp")
INCLUDE = re.compile(r'\s*#\s*include\s*(["<])([^">]+)[">]')
NOT_OURS = {"node_modules", "__pycache__", "build", "out"}

Include = collections.namedtuple("Include", "file line header quoted")
RoomException = collections.namedtuple("RoomException", "line circle source target reason")


class WrongTable(Exception):
    """A line of a table of rules that cannot be read."""


def files_below(root, folder):
    """All files of a folder, without what tools put there."""
    return sorted(path for path in (root / folder).rglob("*")
                  if path.is_file() and not NOT_OURS.intersection(path.relative_to(root).parts))


def sources_below(root, *folders):
    return [path for folder in folders for path in files_below(root, folder) if path.suffix in SOURCES]


def lines_of_table(path):
    """Number and text of each line that says something."""
    for number, line in enumerate(path.read_text().splitlines(), 1):
        if line.strip() and not line.startswith("#"):
            yield number, line.strip()


class Rooms:
    """rooms.txt: the rooms in order, in groups, and the exceptions."""

    def __init__(self, path):
        self.path = path
        self.order, self.lines, self.groups, self.exceptions = [], {}, {}, []
        for number, line in lines_of_table(path):
            self.read(number, line)

    def read(self, number, line):
        exception = re.fullmatch(r"(except|circle) (\S+) -> (\S+): (.+)", line)
        if exception:
            self.exceptions.append(RoomException(number, exception[1] == "circle", *exception.groups()[1:]))
        elif re.fullmatch(r"\[[^]]+\]", line):
            self.groups[line[1:-1]] = []
        elif re.fullmatch(r"[\w/]+", line) and line not in self.lines and self.groups:
            self.lines[line] = number
            self.order.append(line)
            self.groups[list(self.groups)[-1]].append(line)
        else:
            raise WrongTable(f"{self.path}:{number}: expected a new room, [GROUP], or an exception with its reason: {line}")

    def exceptions_for(self, file, room, header, target):
        """Exceptions for an include of `header` of the room `target` by `file` of `room`."""
        return [e for e in self.exceptions if e.source in (file, room) and e.target in (header, target)]


def room_of_file(path):
    """The room of a file by its path below framework/."""
    folder = path.parent.as_posix()
    return re.sub(r"^include/opal/?", "", folder) if folder.startswith("include/opal") else folder


def room_of_header(header):
    """The room of a header by the path in the include line."""
    return pathlib.PurePosixPath(re.sub(r"^opal/", "", header)).parent.as_posix()


def includes_of(path):
    for number, line in enumerate(path.read_text().splitlines(), 1):
        found = INCLUDE.match(line)
        if found:
            yield Include(path, number, found[2], found[1] == '"')


def is_public(include):
    return include.header.startswith("opal/")


def is_private(include, framework):
    return not is_public(include) and (framework / include.header).is_file()


def framework_includes(root):
    """Includes between files of framework/, as (including file below framework/, its room, include, included room)."""
    framework = root / "framework"
    for path in sources_below(root, "framework"):
        below = path.relative_to(framework)
        for include in includes_of(path):
            if is_public(include) or is_private(include, framework):
                yield below, room_of_file(below), include, room_of_header(include.header)


def arrows(root):
    """How many include lines lead from one room to another."""
    return collections.Counter((room, target) for _, room, _, target in framework_includes(root) if room != target)

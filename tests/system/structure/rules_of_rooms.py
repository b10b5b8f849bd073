"""Rules of rooms: includes follow their order, headers keep their doors, every room is described."""

import collections
import re

import drawing
from source_tree import framework_includes, includes_of, is_private, is_public, room_of_file, sources_below


def breaks(root, rooms):
    includes = list(framework_includes(root))
    yield from folders_and_table(root, rooms)
    yield from order(includes, rooms)
    yield from circles(includes, rooms)
    yield from doors(root, includes)
    yield from descriptions(root, rooms)
    yield from dependencies(root, includes, rooms)
    yield from library(root, rooms)
    yield from picture(root, rooms)


def folders_and_table(root, rooms):
    """Every folder with sources is a room, and every room a folder."""
    framework = root / "framework"
    known = set()
    for path in sources_below(root, "framework"):
        room = room_of_file(path.relative_to(framework))
        if room not in rooms.lines and room not in known:
            yield path, 1, f"lies in '{room}', which {rooms.path.name} does not list"
        known.add(room)
    for room, line in rooms.lines.items():
        if not (framework / room).is_dir():
            yield rooms.path, line, f"framework/{room} is no folder"


def order(includes, rooms):
    """A room sees the rooms above it."""
    used = set()
    place = {room: k for k, room in enumerate(rooms.order)}
    for file, room, include, target in includes:
        if room == target or room not in place:
            continue
        if target not in place:
            yield include.file, include.line, f"includes {include.header} of '{target}', which is no room"
        elif place[target] > place[room]:
            excused = rooms.exceptions_for(file.as_posix(), room, include.header, target)
            used.update(e.line for e in excused)
            if not excused:
                yield include.file, include.line, (f"'{room}' includes {include.header}, but {rooms.path.name} has "
                                                   f"'{target}' below '{room}'")
    for exception in rooms.exceptions:
        if exception.line not in used:
            yield rooms.path, exception.line, "excuses no include line any more: remove it"


def way(arrows, start, end):
    """The shortest way along the arrows, as rooms; None if there is none."""
    before, rest = {start: None}, [start]
    while rest and end not in before:
        room = rest.pop(0)
        for target in sorted(arrows[room] - before.keys()):
            before[target] = room
            rest.append(target)
    if end not in before:
        return None
    rooms = [end]
    while rooms[-1] != start:
        rooms.append(before[rooms[-1]])
    return rooms[::-1]


def circles(includes, rooms):
    """No includes lead from a room back to it, but for exceptions that say so. Each circle has an arrow against the order."""
    place = {room: k for k, room in enumerate(rooms.order)}
    arrows, against, closing = collections.defaultdict(set), {}, set()
    for file, room, include, target in includes:
        if room == target:
            continue
        excused = [e for e in rooms.exceptions_for(file.as_posix(), room, include.header, target) if e.circle]
        closing.update((e, room, target) for e in excused)
        if not excused:
            arrows[room].add(target)
            if place.get(target, 0) > place.get(room, 0):
                against.setdefault((room, target), include)
    for (room, target), include in against.items():
        back = way(arrows, target, room)
        if back:
            yield include.file, include.line, "closes a circle: " + " includes ".join(f"'{one}'" for one in [room, *back])
    for _, room, target in closing:
        arrows[room].add(target)
    for exception, room, target in sorted(closing):
        if not way(arrows, target, room):
            yield rooms.path, exception.line, "closes no circle: write 'except'"


def doors(root, includes):
    """Public headers include public ones; plugins see public ones only; include lines name the room."""
    framework = root / "framework"
    for file, _, include, _ in includes:
        if is_public(include) and not (framework / "include" / include.header).is_file():
            yield include.file, include.line, f"includes {include.header}, which is no public header"
        if file.parts[0] == "include" and not is_public(include):
            yield include.file, include.line, f"is a public header and includes the private {include.header}"
    for path in sources_below(root, "framework"):
        for include in includes_of(path):
            if include.quoted and not is_public(include) and not is_private(include, framework):
                yield path, include.line, f"includes \"{include.header}\", which is no path below framework/"
    for path in sources_below(root, "plugins", "patterns"):
        for include in includes_of(path):
            if is_private(include, framework) and not (path.parent / include.header).is_file():
                yield path, include.line, f"includes {include.header}; a plugin sees <opal/...> only"


def descriptions(root, rooms):
    """Every room has a README, and framework/README.md names the rooms in their order."""
    page = root / "framework" / "README.md"
    text = page.read_text()
    for room in rooms.order:
        if not (root / "framework" / room / "README.md").is_file():
            yield rooms.path, rooms.lines[room], f"framework/{room} has no README.md"
        if f"({room}/README.md)" not in text:
            yield page, 1, f"does not name the room '{room}' with a link to {room}/README.md"
    last = -1
    for number, line in enumerate(text.splitlines(), 1):
        if line.startswith("#"):
            last = -1
        named = re.match(r"\| \[([\w/]+)\]\(\1/README\.md\) \|", line)
        if not named or named[1] not in rooms.lines:
            continue
        if rooms.order.index(named[1]) < last:
            yield page, number, f"names '{named[1]}' below a room that is below it in {rooms.path.name}"
        last = rooms.order.index(named[1])


DEPENDENCIES = re.compile(r"\| may depend on \|(.*)\|\s*$")
PATH = re.compile(r"`([\w/]+)`")


def row_of(readme):
    """Number and text of the row 'may depend on' of a README; None if there is none."""
    rows = ((number, DEPENDENCIES.match(line)) for number, line in enumerate(readme.read_text().splitlines(), 1))
    return next(((number, found[1]) for number, found in rows if found), None)


def permits(row, room, target, rooms):
    """Whether the row of `room` names `target`, or a room around it. Its own folders belong to a room."""
    whole = "the library" in row and target in rooms.groups.get("libopal.so", [])
    named = [room, *PATH.findall(row)]
    return whole or "all rooms" in row or any(target == name or target.startswith(name + "/") for name in named)


def dependencies(root, includes, rooms):
    """A room includes no more than the row 'may depend on' of its README names, and the row names rooms."""
    used = collections.defaultdict(dict)
    for _, room, include, target in includes:
        if room != target:
            used[room].setdefault(target, include)
    for room in rooms.order:
        readme = root / "framework" / room / "README.md"
        number, row = (readme.is_file() and row_of(readme)) or (1, "")
        for name in PATH.findall(row):
            if not any(one == name or one.startswith(name + "/") for one in rooms.order):
                yield readme, number, f"may depend on '{name}', which is no room"
        for target, include in sorted(used[room].items()):
            if not permits(row, room, target, rooms):
                yield readme, number, (f"does not say that '{room}' may depend on '{target}', but "
                                       f"{include.file.relative_to(root)}:{include.line} includes {include.header}")


def library(root, rooms):
    """[libopal.so] is what CMake compiles into it."""
    listing = root / "framework" / "CMakeLists.txt"
    found = re.search(r"^set\(rooms ([\w\s/]+)\)", listing.read_text(), re.MULTILINE)
    compiled = set(found[1].split()) if found else set()
    listed = {room.split("/")[0] for room in rooms.groups.get("libopal.so", [])}
    if compiled != listed:
        yield listing, 1, f"libopal.so is made of {sorted(compiled)}, and of {sorted(listed)} in {rooms.path.name}"


def picture(root, rooms):
    """The drawing shows these rooms and arrows. It is not drawn here, so graphviz is not needed."""
    path = root / "docs" / "structure.svg"
    if not path.is_file() or drawing.mark(drawing.graph(root, rooms)) not in path.read_text():
        yield path, 1, "shows other rooms or arrows: draw it again with tests/system/structure/draw_rooms.py"

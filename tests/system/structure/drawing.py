"""The rooms and their includes as a graph for graphviz: libopal.so in one box, in the order of the data, tools below."""

import collections
import hashlib

from source_tree import framework_includes

FOLDED = ("jsonld", "simulation", "viewer", "benchmark", "cli")  # drawn as one room each
HIDDEN = ("cmake",)
LIBRARY = "libopal.so"
BOXES = ("localization", "map")  # rooms with their folders, in a box of their own
FILLS = {LIBRARY: "#dcebf7", "tools": "#f3efe2", "the program opal": "#e6f2e0"}


def drawn(room):
    parent = room.split("/")[0]
    return parent if parent in FOLDED else room


def arrows(root, rooms):
    """Arrows along the order, without those that longer ways imply, and the exceptions."""
    place = {room: k for k, room in enumerate(rooms.order)}
    down, against = collections.defaultdict(set), set()
    for _, room, _, target in framework_includes(root):
        a, b = drawn(room), drawn(target)
        if a == b or b in HIDDEN or a in HIDDEN or target not in place or room not in place:
            continue
        if place[target] < place[room]:
            down[a].add(b)
        else:
            against.add((a, b))
    return reduced(down), sorted(against)


def reduced(down):
    below = {}

    def reached(room):
        if room not in below:
            below[room] = set().union(*({next_room} | reached(next_room) for next_room in down.get(room, ())))
        return below[room]

    return sorted((a, b) for a in list(down) for b in down[a]
                  if not any(b in reached(other) for other in down[a] if other != b))


def node(room, fill):
    label = room.split("/")[-1] if room.split("/")[0] in BOXES else room
    return f'"{room}" [label="{label}", fillcolor="{fill}"];'


def group_of(name, rooms):
    """One box with the rooms of a group; rooms with folders get a box inside."""
    fill = FILLS.get(name, "#ffffff")
    shown = list(dict.fromkeys(drawn(room) for room in rooms if room not in HIDDEN))
    plain = [room for room in shown if room.split("/")[0] not in BOXES]
    lines = [node(room, fill) for room in plain]
    for box in BOXES:
        inner = [room for room in shown if room.split("/")[0] == box]
        if inner:
            lines += [f'subgraph "cluster_{box}" {{ label="{box}"; labelloc=b; labeljust=l; style="rounded"; color="#7f9db5"; fontsize=12;',
                      *(node(room, "#ffffff") for room in inner), "}"]
    return lines


def graph(root, rooms):
    down, against = arrows(root, rooms)
    lines = ["digraph rooms {",
             'rankdir=BT; ranksep=0.42; nodesep=0.28; fontname="Helvetica"; fontsize=15; bgcolor="white";',
             'node [shape=box, style="filled,rounded", fontname="Helvetica", fontsize=13, color="#52606d",',
             'height=0.34, margin="0.12,0.05"];',
             'edge [color="#52606d", arrowsize=0.6];']
    for name, members in rooms.groups.items():
        inside = group_of(name, members)
        if name == LIBRARY:
            inside = ['subgraph "cluster_library" {', f'label="{LIBRARY}"; labelloc=b; labeljust=l;',
                      'style="rounded,filled"; fillcolor="#f4f9fd"; color="#2f6f9f";', *inside, "}"]
        lines += inside
    library = {drawn(room) for room in rooms.groups.get(LIBRARY, [])}
    lines += [f'"{room}" -> "{rooms.groups[LIBRARY][-1]}" [style=invis, minlen=2];'
              for room in sorted({drawn(room) for room in rooms.order if room not in HIDDEN} - library)]  # tools stand below
    for a, b in down:
        crossing = a not in library and b in library
        lines.append(f'"{a}" -> "{b}"' + (' [color="#a9b4bf"];' if crossing else ";"))
    lines += [f'"{a}" -> "{b}" [style=dashed, color="#c0392b", constraint=false];' for a, b in against]
    return "\n".join([*lines, "}"]) + "\n"


def digest(text):
    return hashlib.sha256(text.encode()).hexdigest()[:16]


def mark(text):
    """What a picture carries to tell which graph it shows."""
    return f"<!-- rooms {digest(text)} -->"

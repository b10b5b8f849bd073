"""Mistakes in where results go."""

from making import copy, file
from mistake import Mistake
from table_commands import run_of_the_corridor

RUN = "localize {configs}/malaga.jsonld {malaga}/malaga-demo.log.gz --map {malaga}/malaga-demo.map.yaml -o %s"
IMPORT = "map import {malaga}/malaga-demo.map.yaml -o %s"

MISTAKES = [
    Mistake("file instead of a folder", "Results shall go into a file.", RUN % "notes.txt", 4,
            ["notes.txt", "Not a directory"], make=file("notes.txt", "mine\n")),
    Mistake("sketch into a file", "Sketches of maps shall go into a file.",
            "map sketch {maps}/example_room.jsonld -o notes.txt", 4,
            ["notes.txt: the folder cannot be made: Not a directory"], make=file("notes.txt", "mine\n")),
    Mistake("folder below a file", "Results shall go into a folder below a file.", RUN % "notes.txt/out", 4,
            ["notes.txt/out", "Not a directory"], make=file("notes.txt", "mine\n")),
    Mistake("folder that nobody can write", "Results shall go where the system forbids it.", RUN % "/proc/opal", 4,
            ["/proc/opal", "cannot be made"]),
    Mistake("folder instead of a file", "The map shall be written into a folder by the folder's name.",
            IMPORT % "maps", 4, ["maps: cannot be written: Is a directory"], make=file("maps/x.txt", "")),
    Mistake("file in a missing folder", "The map shall be written into a folder that does not exist.",
            IMPORT % "nowhere/map.jsonld", 4, ["nowhere/map.jsonld: cannot be written: No such file or directory"]),
    Mistake("full disk", "The disk is full.", IMPORT % "/dev/full", 4,
            ["/dev/full: cannot be written: No space left on device"]),
    Mistake("largest file", "The largest file that is allowed is too small (`ulimit -f`).", RUN % "out", 4,
            ["opal: out/", "cannot be written: File too large", "ulimit -f"], largest_kb=40),
    Mistake("largest map", "The map is larger than the largest file that is allowed.", IMPORT % "map.jsonld", 4,
            ["map.jsonld: cannot be written: File too large"], largest_kb=4, absent=["map.jsonld"]),
    Mistake("printed onto a full disk", "What is printed goes to a full disk.", "map check {maps}/gemini.jsonld", 4,
            ["standard output: cannot be written: No space left on device"], stdout="/dev/full"),
    Mistake("map over its own source", "`opal map import` shall write over the file that it reads.",
            "map import malaga-demo.map.yaml -o ./malaga-demo.map.yaml", 3,
            ["malaga-demo.map.yaml: is read as SOURCE, expected another file for --out"],
            make=copy("malaga-demo.map.yaml", "malaga-demo.map.pgm")),
    Mistake("list over a map", "`opal learn` shall write its list over the map.",
            "learn malaga-demo.map.yaml {maps}/gemini.jsonld -o learned.jsonld --csv ./malaga-demo.map.yaml", 3,
            ["malaga-demo.map.yaml: is read as MAP, expected another file for --csv"],
            make=copy("malaga-demo.map.yaml", "malaga-demo.map.pgm")),
    Mistake("deployment over a recording", "`opal info` shall write the deployment into the recording.",
            "info malaga-demo.log.gz -o malaga-demo.log.gz", 3,
            ["malaga-demo.log.gz: is read as LOG, expected another file for --out"], make=copy("malaga-demo.log.gz")),
    Mistake("recording over its own map", "`opal simulate` shall write over the recording whose map it reads.",
            "simulate malaga-demo.map.yaml -o malaga-demo", 3,
            ["malaga-demo.map.yaml: is the map that is driven in, expected another PREFIX to write"],
            make=copy("malaga-demo.map.yaml", "malaga-demo.map.pgm"), absent=["malaga-demo.log.gz"]),
    Mistake("page onto a full disk", "`opal view` has no room for its page.", "view out -o /dev/full", 4,
            ["/dev/full: cannot be written: No space left on device"], make=run_of_the_corridor),
]

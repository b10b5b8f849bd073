"""Mistakes in the map."""

from making import both, copy, file, grid
from mistake import TREE, Mistake

RUN = "localize {configs}/malaga.jsonld {malaga}/malaga.log.gz -o out --map %s"
LOST = ["at the end: "]
NONSENSE = ["at the end: localized"]


def room(old, new):
    """The example room as wrong.jsonld, with one thing replaced."""
    return file("wrong.jsonld", (TREE / "maps" / "example_room.jsonld").read_text().replace(old, new, 1))


MISTAKES = [
    Mistake("map of another building", "The map is that of another building.", RUN % "{maps}/gemini.jsonld", 1, LOST,
            never=NONSENSE),
    Mistake("map in millimetres", "The grid's resolution is in millimetres.", RUN % "mm.yaml", 3,
            ["mm.yaml: line 2: resolution: 50, expected a cell size from 0.001 to 10 m"],
            make=grid("mm.yaml", lambda text: text.replace("resolution: 0.05", "resolution: 50")), absent=["out"]),
    Mistake("map of half the size", "The grid's resolution is half of what it should be.", RUN % "half.yaml", 1, LOST,
            make=grid("half.yaml", lambda text: text.replace("resolution: 0.05", "resolution: 0.025")), never=NONSENSE),
    Mistake("map with resolution zero", "The grid's resolution is zero.", "map check zero.yaml", 3,
            ["zero.yaml: line 2: resolution: 0, expected a cell size"],
            make=grid("zero.yaml", lambda text: text.replace("resolution: 0.05", "resolution: 0"))),
    Mistake("map without its image", "The yaml was copied without its image.", "map check malaga-demo.map.yaml", 3,
            ["malaga-demo.map.pgm: cannot read the file: No such file or directory"], make=copy("malaga-demo.map.yaml")),
    Mistake("map without a resolution", "A line of the grid's yaml is missing.", "map check none.yaml", 3,
            ["none.yaml: resolution is missing"],
            make=grid("none.yaml", lambda text: "\n".join(line for line in text.split("\n") if "resol" not in line))),
    Mistake("map with nothing on it", "The grid is white.", RUN % "white.yaml", 3,
            ["white.yaml: 0 cells are occupied and", "no wall is between them, expected a building"],
            make=both(file("white.pgm", b"P5\n200 200\n255\n" + b"\xfe" * 40000),
                      file("white.yaml", "image: white.pgm\nresolution: 0.05\norigin: [0, 0, 0]\nnegate: 0\n"
                                         "occupied_thresh: 0.65\nfree_thresh: 0.196\n")), absent=["out"]),
    Mistake("map in negative", "Black and white of the grid are swapped.", RUN % "negative.yaml", 1, LOST,
            make=grid("negative.yaml", lambda text: text.replace("negate: 0", "negate: 1")), never=NONSENSE),
    Mistake("configuration instead of a map", "A configuration stands where a map document is expected.",
            "map check {configs}/malaga.jsonld", 3, ["malaga.jsonld", "Deployment"]),
    Mistake("map with a wrong number", "A coordinate of the map is a text.", "map check wrong.jsonld", 3,
            ["wrong.jsonld: /@graph/2", "is \"zero\", expected a number"],
            make=room("0.0", '"zero"')),
    Mistake("map with a heading in degrees", "The heading of a corner is in degrees.", "map check wrong.jsonld", 0,
            ["1 corner with a heading_rad of more than a turn, are these degrees?"], make=room("0.7853981633974483", "45")),
    Mistake("map in millimetres by hand", "Coordinates of a map document are in millimetres.", "map check wrong.jsonld", 0,
            ["longer than 1 km, are these millimetres?"], make=room('"x": 8.0', '"x": 8000')),
    Mistake("map with a misspelt type", "A type is misspelt.", "map check wrong.jsonld", 0,
            ["type opal:Wal is no word of Opal's vocabulary, is opal:Wall meant?"], make=room('"@type": "Wall"', '"@type": "opal:Wal"')),
    Mistake("map with an undefined prefix", "A property has a prefix that the context does not define.",
            "map check wrong.jsonld", 3, ["key lab:owner: @context does not define the prefix 'lab'"],
            make=room('"@type": "Wall"', '"lab:owner": "me", "@type": "Wall"')),
    Mistake("overlay of another map", "The overlay speaks of objects that the map does not have.",
            "map overlay {maps}/gemini.jsonld {maps}/overlays/example_room.jsonld -o over.jsonld", 3,
            ["overlays/example_room.jsonld: /@graph/1", "which the document does not define"], absent=["over.jsonld"]),
    Mistake("one map twice", "`opal map join` gets the same map twice.",
            "map join {maps}/gemini.jsonld {maps}/gemini.jsonld -o two.jsonld", 3, ["two maps are called 'gemini', expected a name for each"],
            absent=["two.jsonld"]),
    Mistake("grid named after its image", "`opal map raster` is told to write the image instead of the yaml.",
            "map raster {maps}/example_room.jsonld -o room.pgm", 3, ["room.pgm: expected a name that ends with .yaml"], absent=["room.pgm"]),
]

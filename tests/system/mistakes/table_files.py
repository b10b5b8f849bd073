"""Mistakes in files and folders that are named."""

from making import both, changed_json, copy, cut, file
from mistake import MALAGA, TREE, Mistake
from table_commands import LOCALIZE, run_of_the_corridor

RUN = "localize {configs}/malaga.jsonld %s --map {malaga}/malaga-demo.map.yaml -o out"
WITH = LOCALIZE + " %s"


def events(change):
    """A run of the corridor whose events are changed."""

    def make(bench):
        run_of_the_corridor(bench)
        file = bench.path("out/events.jsonl")
        file.write_text(change(file.read_text()))

    return make


def garbled(text):
    lines = text.splitlines()
    lines[20] = lines[20][:30] + "#" + lines[20][30:]
    return "\n".join(lines) + "\n"


MISTAKES = [
    Mistake("missing configuration", "The configuration's name is misspelled.",
            "localize nowhere.jsonld {malaga}/malaga-demo.log.gz -o out", 3,
            ["nowhere.jsonld: does not exist, and is none of the configurations that ship: "], absent=["out"]),
    Mistake("missing log", "The log's name is misspelled.", RUN % "nowhere.log.gz", 3,
            ["nowhere.log.gz: does not exist"], absent=["out"]),
    Mistake("missing map", "The map's name is misspelled.",
            "localize {configs}/malaga.jsonld {malaga}/malaga.log.gz --map nowhere.yaml -o out", 3,
            ["nowhere.yaml: does not exist"], absent=["out"]),
    Mistake("missing map document", "The map document's name is misspelled.",
            "localize {configs}/malaga.jsonld {malaga}/malaga.log.gz --map nowhere.jsonld -o out", 3,
            ["nowhere.jsonld: cannot be opened: No such file or directory"], absent=["out"]),
    Mistake("missing queries", "The file of queries is misspelled.", WITH % "--queries nowhere.json", 3,
            ["nowhere.json: cannot be opened: No such file or directory"], absent=["out"]),
    Mistake("missing truth", "The file of recorded truth is misspelled.", WITH % "--truth nowhere.csv", 3,
            ["nowhere.csv: cannot be read: No such file or directory"], absent=["out"]),
    Mistake("folder instead of a configuration", "A folder stands where a configuration is expected.",
            "localize {configs} {malaga}/malaga-demo.log.gz -o out", 3, ["configs: is a folder, expected a JSON file"], absent=["out"]),
    Mistake("folder instead of a log", "A folder stands where a log is expected.", RUN % "{malaga}", 3,
            ["maps/malaga: is a folder, expected a log"], absent=["out"]),
    Mistake("folder instead of a map", "A folder stands where a map is expected.",
            "map check {malaga}", 3, ["maps/malaga: is a folder, expected a map document"]),
    Mistake("empty configuration", "The configuration is an empty file.",
            "localize empty.jsonld {malaga}/malaga-demo.log.gz -o out", 3,
            ["empty.jsonld: line 1, column 1: no content"], make=file("empty.jsonld", ""), absent=["out"]),
    Mistake("empty log", "The log is an empty file.", RUN % "empty.log", 3,
            ["empty.log: is empty, expected a recorded log"],
            make=file("empty.log", ""), absent=["out"]),
    Mistake("empty map", "The map document is an empty file.", "map check empty.jsonld", 3,
            ["empty.jsonld: line 1, column 1: no content"], make=file("empty.jsonld", "")),
    Mistake("truncated configuration", "The configuration was copied in part.",
            "localize cut.jsonld {malaga}/malaga-demo.log.gz -o out", 3,
            ["cut.jsonld: line 10, column 10: syntax error"],
            make=cut(TREE / "configs" / "malaga.jsonld", "cut.jsonld", 0.6), absent=["out"]),
    Mistake("truncated log", "The log was copied in part.", RUN % "cut.log.gz", 0, ["log: truncated file: 1 times"],
            make=cut(MALAGA / "malaga-demo.log.gz", "cut.log.gz", 0.7)),
    Mistake("truncated map", "The image of the grid was copied in part.", "map check malaga-demo.map.yaml", 3,
            ["malaga-demo.map.pgm", "bytes of pixels until the end of the file, expected 734976"],
            make=both(copy("malaga-demo.map.yaml"), cut(MALAGA / "malaga-demo.map.pgm", "malaga-demo.map.pgm", 0.5))),
    Mistake("truncated map document", "The map document was copied in part.", "map check cut.jsonld", 3,
            ["cut.jsonld: line ", "syntax error"], make=cut(TREE / "maps" / "gemini.jsonld", "cut.jsonld", 0.5)),
    Mistake("truncated events", "The events of a run were copied in part.", "view out", 0, ["cut off"],
            make=events(lambda text: text[: int(0.7 * len(text)) // 2 * 2])),
    Mistake("damaged events", "A line of the events is damaged.", "view out", 3, ["out/events.jsonl:21"],
            make=events(garbled)),
    Mistake("picture instead of a log", "Some other file stands where a log is expected.",
            RUN % "{malaga}/malaga-demo.map.pgm", 3, ["malaga-demo.map.pgm: no log source recognizes this file; logs are read by", "opal:CarmenLog"],
            absent=["out"]),
    Mistake("pointer instead of a model", "A clone without Git LFS has pointers in the place of large files.", "map check office.ifc", 3,
            ["office.ifc: is a pointer of Git LFS, expected the file itself"],
            make=file("office.ifc", "version https://git-lfs.github.com/spec/v1\noid sha256:4d7a\nsize 12345\n")),
    Mistake("web page instead of a drawing", "The page that shows the drawing was saved.", "map check plan.dxf", 3,
            ["plan.dxf: is a web page, expected the file that it shows"], make=file("plan.dxf", "\n<!DOCTYPE html>\n<html></html>\n")),
    Mistake("archive instead of a map", "The archive of an IMDF was not unpacked.", "map check venue.zip", 3,
            ["venue.zip: is a ZIP archive, expected what is in it: unpack it first"], make=file("venue.zip", b"PK\x03\x04 and so on")),
    Mistake("picture instead of a map", "The image of the grid was named, not its yaml file.", "map check {malaga}/malaga-demo.map.pgm", 3,
            ["malaga-demo.map.pgm: is a picture, expected the map_server yaml file"]),
    Mistake("log instead of a map", "The log stands where a map is expected.",
            "map check {malaga}/malaga-demo.log.gz", 3, ["malaga-demo.log.gz: no importer recognizes this file; maps are read from"]),
    Mistake("damaged archive", "The log ends with .gz and is none.", RUN % "wrong.log.gz", 3,
            ["wrong.log.gz: no log source recognizes this file"],
            make=file("wrong.log.gz", b"\x1f\x8b\x08\x00 this is no archive"), absent=["out"]),
    Mistake("empty bag", "The ROS 2 bag is no database.", RUN % "wrong.db3", 3,
            ["wrong.db3: no log source recognizes this file"],
            make=file("wrong.db3", "no database\n"), absent=["out"]),
    Mistake("names with spaces and accents", "Files and folders have spaces and letters beyond ASCII: no mistake.",
            "localize {configs}/malaga.jsonld 'my löğ ∅.log.gz' --map {malaga}/malaga-demo.map.yaml -o 'my rûn'", 0,
            ["at the end: localized", "written to my rûn"], make=copy(("malaga-demo.log.gz", "my löğ ∅.log.gz"))),
    Mistake("huge number", "A grid says that it is larger than any building.", "map check huge.yaml", 3,
            ["huge.pgm: header: 2000000000 x 2000000000 pixels, expected at most"],
            make=both(file("huge.pgm", b"P5\n2000000000 2000000000\n255\n\x00"),
                      file("huge.yaml", "image: huge.pgm\nresolution: 0.05\norigin: [0, 0, 0]\nnegate: 0\n"
                                        "occupied_thresh: 0.65\nfree_thresh: 0.196\n"))),
    Mistake("huge document", "A document is nested deeper than any map.", "map check deep.jsonld", 3,
            ["deep.jsonld: /0/0/0", "...: nested more deeply than expected"], make=file("deep.jsonld", "[" * 100000 + "]" * 100000)),
]

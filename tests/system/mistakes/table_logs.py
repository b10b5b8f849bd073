"""Mistakes in the log."""

from making import both, file, log, only, poses, ranges, stamps
from mistake import Mistake, log_lines

RUN = "localize {configs}/malaga.jsonld wrong.log --map {malaga}/malaga-demo.map.yaml -o out"
NONSENSE = ["at the end: localized"]


def mixed(log):
    """Another robot's log behind, with its own clock and odometry."""
    log.lines += [words[:] for words in log.lines[:30]]


def shuffled(log):
    log.lines = log.lines[:1] + log.lines[:0:-1]


BAG, MCAP = "#ROSBAG V2.0\n", b"\x89MCAP0\r\n"

MISTAKES = [
    Mistake("folder of several recordings", "A folder has the bags of two drives.", "info drives", 3,
            ["drives: several recordings (monday.bag, tuesday.bag), expected one of them"],
            make=both(file("drives/monday.bag", BAG), file("drives/tuesday.bag", BAG))),
    Mistake("folder of several kinds", "A folder has a bag and an MCAP file.", "info drives", 3,
            ["drives: several recordings (for opal:McapLog and for opal:Ros1Bag), expected one of them"],
            make=both(file("drives/monday.bag", BAG), file("drives/tuesday.mcap", MCAP))),
    Mistake("log without scans", "The log has odometry only.", RUN, 3,
            ["wrong.log: no scan that can be read", "expected scans of a planar laser"],
            make=log(only("ODOM"))),
    Mistake("log without odometry", "Wheel odometry was not recorded: every pose is zero.", RUN, 1,
            ["log: odometry never moves in 37 scans"], make=log(poses(lambda x, y, heading: (0, 0, 0))), never=NONSENSE),
    Mistake("ranges in millimetres", "The ranges are in millimetres.", RUN, 1,
            ["at the end: searching", "no beam of 37 scans returns", "expected ranges in metres"],
            make=log(ranges(lambda words: [f"{1000 * float(word):.0f}" for word in words])), never=NONSENSE),
    Mistake("ranges in centimetres", "The ranges are in centimetres.", RUN, 1, ["at the end: "],
            make=log(ranges(lambda words: [f"{100 * float(word):.0f}" for word in words])), never=NONSENSE),
    Mistake("headings in degrees", "The headings of odometry are in degrees.", RUN, 1, ["at the end: "],
            make=log(poses(lambda x, y, heading: (x, y, 57.29578 * heading))), never=NONSENSE),
    Mistake("swapped axes", "x and y of odometry are swapped.", RUN, 1, ["odometry"],
            make=log(poses(lambda x, y, heading: (y, x, heading))), never=NONSENSE),
    Mistake("stamps in nanoseconds", "The times are in nanoseconds.", RUN, 3,
            ["wrong.log: no scan that can be read", "74 times 'stamp that is no time'"],
            make=log(stamps(lambda stamp: f"{1e9 * (1.7e9 + float(stamp)):.0f}")), never=NONSENSE),
    Mistake("two logs in one", "Two logs were joined: time runs backwards in the middle.", RUN, 1,
            ["log: clock reset: 1 times"],
            make=log(mixed)),
    Mistake("lines in the wrong order", "The lines of the log were sorted backwards.", RUN, 1,
            ["log: scan stamp steps back: 28 times"],
            make=log(shuffled), never=NONSENSE),
    Mistake("decimal commas", "The numbers have decimal commas.", RUN, 3,
            ["wrong.log: no scan that can be read", "74 times 'malformed line'"],
            make=file("wrong.log", "\n".join(line.replace(".", ",") for line in log_lines()) + "\n"), never=NONSENSE),
    Mistake("ends of lines of Windows", "The log went through an editor under Windows: no mistake.", RUN, 0,
            ["at the end: localized"], make=file("wrong.log", "\r\n".join(log_lines()) + "\r\n")),
    Mistake("beams left out", "Lines have fewer ranges than they say.", RUN, 3,
            ["wrong.log: no scan that can be read", "37 times 'malformed line'"],
            make=file("wrong.log", "\n".join(" ".join(line.split()[:200]) for line in log_lines()) + "\n"),
            never=NONSENSE),
    Mistake("laser that sees nothing", "All ranges are zero: the laser was covered.", RUN, 1,
            ["at the end: searching", "no beam of 37 scans returns"],
            make=log(ranges(lambda words: ["0"] * len(words))), never=NONSENSE),
    Mistake("queries of another log", "The queries are those of another recording.",
            "localize {configs}/malaga.jsonld {malaga}/malaga-demo.log.gz --map {malaga}/malaga-demo.map.yaml "
            "--queries queries.json -o out", 3,
            ["queries.json: query 'late' from 1000.0 to 1010.0 s has no scan of", "expected times from 0.0 to 9.3 s"],
            make=file("queries.json", '{"queries": [{"id": "late", "start_time": 1000, "end_time": 1010}]}'),
            never=NONSENSE),
    Mistake("truth of another log", "The recorded truth is that of another recording.",
            "localize {configs}/malaga.jsonld {malaga}/malaga-demo.log.gz --map {malaga}/malaga-demo.map.yaml "
            "--truth truth.csv -o out", 3,
            ["truth.csv: covers 1000.0 to 1001.0 s and no scan of", "expected times from 0.0 to 9.3 s"], absent=["out"],
            make=file("truth.csv", "timestamp,x,y,theta,is_scan\n1000,0,0,0,1\n1001,1,0,0,1\n")),
    Mistake("truth with swapped columns", "The truth's columns stand in another order.",
            "localize {configs}/malaga.jsonld {malaga}/malaga-demo.log.gz --map {malaga}/malaga-demo.map.yaml "
            "--truth truth.csv -o out", 3,
            ["truth.csv: line 1: 'x,y,theta,timestamp'", "expected the header timestamp,x,y,theta"],
            make=file("truth.csv", "x,y,theta,timestamp\n0,0,0,1\n"), absent=["out"]),
    Mistake("start pose far away", "`opal track` starts ten metres beside the robot.",
            "track {configs}/malaga.jsonld {malaga}/malaga.log.gz --pose 12,-9,2 -o out", 1, ["lost: at the end"]),
]

"""Mistakes in the description of the robot and its laser."""

import math

from making import config, file, log, poses
from mistake import Mistake

RUN = "localize config.jsonld {malaga}/malaga-demo.log.gz -o out"
NONSENSE = ["at the end: localized"]


def sensor(**changes):
    return config(lambda document: document["sensor"].update(changes))


def no_mount(document):
    del document["sensor"]["T_base_laser"]


def two_lasers(front, rear):
    def change(document):
        sensor = document["sensor"]
        document["sensor"] = [dict(sensor, frame=front), dict(sensor, frame=rear)]

    return change


def both_scans(log):
    for words in log.lines:
        if words[0] == "FLASER":
            end = 2 + int(words[1])
            words[2:end] = words[2:end][::-1]


MISTAKES = [
    Mistake("angles in degrees", "The laser's first angle is in degrees.", RUN, 3,
            ["config.jsonld", "/sensor/angle_min_rad", "-90"], make=sensor(angle_min_rad=-90), absent=["out"]),
    Mistake("mount in millimetres", "The laser's place on the robot is in millimetres.", RUN, 3,
            ["config.jsonld", "/sensor/T_base_laser/x_m", "780"],
            make=sensor(T_base_laser={"x_m": 780, "y_m": 0, "heading_rad": 0}), absent=["out"]),
    Mistake("no mount", "The configuration does not say where the laser is.", RUN, 0,
            ["sensor: nothing says where the laser sits on the robot (config.jsonld: /sensor/T_base_laser)"],
            make=config(no_mount)),
    Mistake("no mount to track with", "The same while a robot is tracked from a known pose.",
            "track config.jsonld {malaga}/malaga-demo.log.gz --truth {malaga}/malaga-demo.gt.csv -o out", 0,
            ["sensor: nothing says where the laser sits on the robot (config.jsonld: /sensor/T_base_laser)"],
            make=config(no_mount)),
    Mistake("two lasers of one name", "Two lasers are described, and nothing tells them apart.", RUN, 3,
            ["config.jsonld", "/sensor/1/frame", "that no other sensor has"],
            make=config(two_lasers("FLASER", "FLASER")), absent=["out"]),
    Mistake("a laser that the log has not", "Two lasers are described, and the log has one.", RUN, 0,
            ["sensor: laser RLASER: no scan in the log"],
            make=config(two_lasers("FLASER", "RLASER"))),
    Mistake("a laser of another name", "Two lasers are described, and the log has neither.", RUN, 3,
            ["config.jsonld", "/sensor/0", "has no scan of frame", "FLASER"],
            make=config(two_lasers("LLASER", "RLASER")), absent=["out"]),
    Mistake("frame of another laser", "One laser is described, with a frame that no scan has.", RUN, 3,
            ["config.jsonld: /sensor", "has no scan of frame \"laser\"; its scans have: \"FLASER\""],
            make=sensor(frame="laser"), absent=["out"]),
    Mistake("clockwise beams", "The beams turn clockwise, and a number says so.", RUN, 3,
            ["config.jsonld: /sensor/angle_increment_rad: -0.0087", "geometry_from_log takes beams that turn clockwise"],
            make=sensor(angle_increment_rad=-0.0087266), absent=["out"]),
    Mistake("more beams than the log", "The configuration has 541 beams, the log 361.", RUN, 3,
            ["541", "361", "config.jsonld", "or take it with --info", "malaga-demo.info.json"], make=sensor(beams=541), never=NONSENSE),
    Mistake("laser backwards", "The laser looks to the rear, and the configuration says forwards.", RUN, 1,
            ["laser"], make=sensor(T_base_laser={"x_m": 0.78, "y_m": 0, "heading_rad": math.pi}), never=NONSENSE),
    Mistake("laser upside down", "The beams go clockwise, and the configuration says counter-clockwise.",
            "localize {configs}/malaga.jsonld wrong.log --map {malaga}/malaga-demo.map.yaml -o out", 1, ["mirror"],
            make=log(both_scans), never=NONSENSE),
    Mistake("wheels of another size", "The wheels are 10 % larger than odometry believes.",
            "localize {configs}/malaga.jsonld wrong.log --map {malaga}/malaga-demo.map.yaml -o out", 1, ["odometry"],
            make=log(poses(lambda x, y, heading: (1.1 * x, 1.1 * y, heading))), never=NONSENSE),
    Mistake("no-return value of another laser", "The laser says 81.91 where nothing returns, and the configuration 100.",
            RUN, 1, ["no_return_m", "81.91"], make=sensor(no_return_m=100, range_max_m=100), never=NONSENSE),
    Mistake("no-return value below what returns", "The configuration takes 5 m and more for no return.",
            RUN, 0, ["no_return_m, 5 m, or farther", "they look like returns"],
            make=sensor(no_return_m=5, range_max_m=5)),
    Mistake("range limit of a shorter laser", "The configuration takes hits up to 1.5 m only.",
            RUN, 1, ["range_max_m, 1.5 m, or farther", "they look like returns"], make=sensor(range_max_m=1.5)),
    Mistake("increment in degrees", "The angle from beam to beam is in degrees.", RUN, 3,
            ["config.jsonld", "/sensor/angle_increment_rad", "0.5", "cover a full turn"],
            make=sensor(angle_increment_rad=0.5), absent=["out"]),
    Mistake("description of another laser", "`--info` is that of another robot.",
            "localize {configs}/malaga.jsonld {malaga}/malaga-demo.log.gz --map {malaga}/malaga-demo.map.yaml "
            "--info other.info.json -o out", 3, ["181", "361"],
            make=file("other.info.json", '{"laser": {"n_beams": 181, "angle_min_deg": -90, "angle_increment_deg": 1, '
                                         '"no_return_at_or_above_m": 80, "offset_x_m": 0, "offset_y_m": 0, '
                                         '"offset_theta": 0}}'), never=NONSENSE),
]

"""Mistakes that Opal does not find yet: the one place where they are named, with the reason.

A mistake of the table that stands here has to fail. When Opal finds it, its test says so, and its line goes.
"""

NOT_YET = {
    "no mount": "a laser without a mount is taken to be in the middle of the robot",
    "more beams than the log": "beams of the configuration are not compared with those of the log",
    "laser backwards": "the mount's heading is not compared with how scans move",
    "laser upside down": "the sense of rotation is not compared with how scans move",
    "swapped axes": "odometry is not compared with how scans move",
    "wheels of another size": "odometry's scale is not compared with how scans move",
    "no-return value of another laser": "no_return_m is not compared with the ranges of the log",
    "description of another laser": "beams of --info are not compared with those of the log",
}

"""`opal calibrate` writes what a drive tells, and nothing else. OPAL_PROGRAM is the program."""

import gzip
import json
import math

from test_commands import ROOT, Commands


class Calibrate(Commands):
    def drive(self, change=lambda words, end: None):
        """A simulated drive with turns, each of its scans changed. @return the log"""
        self.opal("simulate", ROOT / "maps" / "gemini.jsonld", "-o", "drive", "--drives", "1", "--distance", "40")
        lines = []
        for words in (line.split() for line in gzip.open(self.folder / "drive.log.gz", "rt")):
            if words and words[0] == "FLASER":
                change(words, 2 + int(words[1]))
            lines.append(" ".join(words))
        (self.folder / "drive.log").write_text("\n".join(lines) + "\n")
        return "drive.log"

    def described(self, heading_rad=0.0):
        laser = json.loads((self.folder / "drive.info.json").read_text())["laser"]
        return self.deployment(sensor={
            "beams": laser["n_beams"], "angle_min_rad": math.radians(laser["angle_min_deg"]),
            "angle_increment_rad": math.radians(laser["angle_increment_deg"]),
            "T_base_laser": {"x_m": laser["offset_x_m"], "y_m": laser["offset_y_m"], "heading_rad": heading_rad}})

    def test_a_laser_that_is_described_backwards_is_turned_round_and_spoils_no_odometry(self):
        log = self.drive()
        self.opal("calibrate", self.described(math.pi), log, "-o", "found.jsonld")
        found = json.loads((self.folder / "found.jsonld").read_text())
        self.assertAlmostEqual(found["sensor"]["T_base_laser"]["heading_rad"], 0, delta=0.05)
        self.assertAlmostEqual(found["odometry"]["distance_scale"], 1, delta=0.05)
        self.opal("calibrate", "found.jsonld", log, "-o", "again.jsonld")

    def test_in_a_list_of_lasers_the_first_one_is_corrected(self):
        log = self.drive()
        config = json.loads((self.folder / self.described(math.pi)).read_text())
        config["sensor"] = [config["sensor"]]
        (self.folder / "list.jsonld").write_text(json.dumps(config))
        self.opal("calibrate", "list.jsonld", log, "-o", "found.jsonld")
        found = json.loads((self.folder / "found.jsonld").read_text())
        self.assertAlmostEqual(found["sensor"][0]["T_base_laser"]["heading_rad"], 0, delta=0.05)

    def test_a_mount_that_a_drive_tells_holds_though_beams_came_from_the_log(self):
        def state_angles(words, end):
            """A ROBOTLASER1 line says where its beams point."""
            beams, ranges, laser = words[1], words[2:end], json.loads((self.folder / "drive.info.json").read_text())["laser"]
            step_rad = math.radians(laser["angle_increment_deg"])
            pose, stamp = words[end:end + 6], words[-3:]
            words[:] = ["ROBOTLASER1", "0", str(math.radians(laser["angle_min_deg"])), str(step_rad * int(beams)), str(step_rad),
                        "80", "0.01", "0", beams, *ranges, "0", *pose, "0", "0", "0", "0", "0", *stamp]
        log = self.drive(state_angles)
        config = json.loads((self.folder / self.described(0.3)).read_text())
        config["sensor"]["geometry_from_log"] = True
        config["log_sources"] = [{"@type": "opal:CarmenLog", "options": {"laser_message": "ROBOTLASER1"}}]
        (self.folder / "stated.jsonld").write_text(json.dumps(config))
        self.opal("calibrate", "stated.jsonld", log, "-o", "found.jsonld")
        sensor = json.loads((self.folder / "found.jsonld").read_text())["sensor"]
        self.assertFalse(sensor["geometry_from_log"])
        self.assertAlmostEqual(sensor["T_base_laser"]["heading_rad"], 0, delta=0.05)
        self.opal("calibrate", "found.jsonld", log)

    def test_a_robot_that_stands_teaches_nothing_and_nothing_is_written(self):
        def stand(words, end):
            words[end:end + 6] = ["0"] * 6
        log = self.drive(stand)
        said = self.opal("calibrate", self.described(), log, "-o", "found.jsonld", exit_code=1)
        self.assertIn("not told", said)
        self.assertFalse((self.folder / "found.jsonld").exists(), said)

    def test_mirrored_scans_are_no_scale_and_nothing_is_written(self):
        def mirror(words, end):
            words[2:end] = words[2:end][::-1]
        log = self.drive(mirror)
        said = self.opal("calibrate", self.described(), log, "-o", "found.jsonld", exit_code=1)
        self.assertIn("mirrored", said)
        self.assertFalse((self.folder / "found.jsonld").exists(), said)


if __name__ == "__main__":
    import unittest
    unittest.main()

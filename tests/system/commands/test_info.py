"""`opal info` on the recordings that ship. OPAL_PROGRAM is the program."""

import gzip
import json

from test_commands import LOG, MAP, Commands


class Info(Commands):
    def test_a_log_is_told_in_words_and_for_programs(self):
        text = self.opal("info", LOG)
        self.assertRegex(text, r"(?m)^scans +37 ")
        self.assertIn("laser scans, frame FLASER: is read\n  361 beams; the log does not state where they point: the deployment has to\n", text)
        contents = json.loads(self.opal("info", LOG, "--json"))
        self.assertEqual(contents["lasers"][0]["beams"], 361)
        self.assertEqual({topic["name"]: topic["messages"] for topic in contents["topics"]}["scans"], 37)

    def test_the_deployment_that_is_written_can_be_used(self):
        self.opal("info", LOG, "--config", "malaga", "-o", "office.jsonld")
        self.assertIn("localized after", self.opal("localize", "office.jsonld", LOG, "--map", MAP, "-o", "out"))

    def test_angles_that_the_log_does_not_state_are_taken_and_told(self):
        said = self.opal("info", LOG, "-o", "office.jsonld")
        self.assertIn("note: the log does not state the angles of its 361 beams", said)
        sensor = json.loads((self.folder / "office.jsonld").read_text())["sensor"]
        self.assertEqual((sensor["beams"], sensor["angle_min_rad"]), (361, -1.570796))
        self.assertAlmostEqual(sensor["angle_increment_rad"] * 360, 3.141593, places=5)

    def test_a_robot_that_stands_and_a_laser_that_sees_nothing_are_pointed_out(self):
        self.assertNotIn("to be aware of", self.opal("info", LOG))
        lines = []
        for words in (line.split() for line in gzip.open(LOG, "rt")):
            if words and words[0] == "FLASER":
                end = 2 + int(words[1])
                words[2:end] = ["0.00"] * int(words[1])
                words[end:end + 6] = ["0"] * 6
            elif words and words[0] == "ODOM":
                words[1:4] = ["0"] * 3
            lines.append(" ".join(words))
        (self.folder / "blind.log").write_text("\n".join(lines) + "\n")
        text = self.opal("info", "blind.log", exit_code=1)
        self.assertIn("laser scans sees nothing", text)
        self.assertIn("odometry odometry never moves", text)

    def test_what_is_no_log_is_refused_with_its_name(self):
        (self.folder / "wrong.bag").write_text("#ROSBAG V1.2\n")
        self.assertIn("wrong.bag: no log source recognizes this file", self.opal("info", "wrong.bag", exit_code=3))
        self.assertIn("missing.mcap: does not exist", self.opal("info", "missing.mcap", exit_code=3))


if __name__ == "__main__":
    import unittest
    unittest.main()

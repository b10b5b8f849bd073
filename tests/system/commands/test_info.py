"""`opal info` on the recordings that ship. OPAL_PROGRAM is the program."""

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

    def test_what_is_no_log_is_refused_with_its_name(self):
        (self.folder / "wrong.bag").write_text("#ROSBAG V1.2\n")
        self.assertIn("wrong.bag: no log source recognizes this file", self.opal("info", "wrong.bag", exit_code=3))
        self.assertIn("missing.mcap: does not exist", self.opal("info", "missing.mcap", exit_code=3))


if __name__ == "__main__":
    import unittest
    unittest.main()

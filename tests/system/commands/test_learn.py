"""`opal learn` on the recording that ships, and a map of it that was made wrong. OPAL_PROGRAM is the program."""

import json

from test_commands import ROOT, Commands

MAP = f"{ROOT}/maps/malaga/malaga.map.yaml"
LOG = f"{ROOT}/maps/malaga/malaga.log.gz"


class DamagedMap(Commands):
    """damaged.jsonld is the map that ships, without a third of its walls."""

    def setUp(self):
        super().setUp()
        self.opal("map", "damage", MAP, "--plan", "1.5", "--damage", "drop=0.3", "--seed", "2", "-o", "damaged.jsonld")


class Learn(DamagedMap):
    def learn(self, *words, **how):
        return self.opal("learn", "damaged.jsonld", *words, "--config", "malaga", "-o", "learned.jsonld", **how)

    def test_walls_that_the_map_lacks_are_learned_and_the_overlay_is_one(self):
        told = self.learn(LOG, "--csv", "learned.csv", "--png", "learned.png")
        self.assertRegex(told, r"learned along [1-9]\d* m in \d+ visits")
        self.assertRegex(told, r"added learned-\d+: a face of [\d.]+ m that the map lacks; on \d+ of \d+ visits")
        self.assertIn("learned-", (self.folder / "learned.csv").read_text())
        self.assertTrue((self.folder / "learned.png").stat().st_size > 1000)
        self.assertIn("added, opal:Wall", self.opal("map", "overlay", "damaged.jsonld", "learned.jsonld", "-o", "built.jsonld"))
        self.opal("localize", "malaga", LOG, "--map", "damaged.jsonld", "--overlay", "learned.jsonld", "-o", "out")

    def test_evidence_is_as_good_as_the_log_in_any_order(self):
        self.learn(LOG, "--evidence", "evidence.json")
        from_log = (self.folder / "learned.jsonld").read_bytes()
        drives = json.loads((self.folder / "evidence.json").read_text())
        drives.append({**drives[0], "drive": "another"})
        written = []
        for number, order in enumerate((drives, drives[::-1])):
            (self.folder / f"{number}.json").write_text(json.dumps(order))
            self.learn(f"{number}.json")
            written.append((self.folder / "learned.jsonld").read_bytes())
        self.assertEqual(written[0], written[1])
        self.learn("evidence.json")
        self.assertEqual((self.folder / "learned.jsonld").read_bytes(), from_log)

    def test_evidence_about_another_map_is_refused(self):
        self.learn(LOG, "--evidence", "evidence.json")
        drives = json.loads((self.folder / "evidence.json").read_text())
        (self.folder / "other.json").write_text(json.dumps({**drives[0], "map": "elsewhere"}))
        self.assertIn('tells of the map "elsewhere"', self.learn("other.json", exit_code=3))


if __name__ == "__main__":
    import unittest
    unittest.main()

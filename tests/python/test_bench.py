"""`opal bench` in Python: the same rows, the same verdict."""

import json
import unittest

import opal
from recorded import DEMO, MAP, InFolder


class Benches(InFolder):
    @classmethod
    def setUpClass(cls):
        cls.bench = opal.bench(DEMO)

    def test_rows_are_those_of_the_program_to_the_byte(self):
        said = self.opal("bench", DEMO, "-o", "out")
        self.bench.run.write_results(str(self.folder / "results.csv"))
        self.bench.run.write_alternatives(str(self.folder / "alternatives.csv"))
        for name in ("results.csv", "alternatives.csv"):
            self.assertEqual((self.folder / name).read_bytes(), (self.folder / "out" / name).read_bytes())
        verdict = json.loads((self.folder / "out" / "summary.json").read_text())["verdict"]
        self.assertEqual(self.bench.verdict, verdict)
        self.assertTrue(said.startswith(self.bench.summary))

    def test_a_frame_has_a_row_per_query_and_one_per_scan(self):
        frame = self.bench.frame()
        self.assertEqual(len(frame), 5)
        self.assertEqual(int(frame.success.sum()), self.bench.verdict["success"])
        rows = self.bench.run.frame()
        self.assertEqual(len(rows), len(self.bench.run))
        self.assertEqual(list(rows.groupby("query_id").size()), list(frame.sort_values("query_id").rows))
        self.assertEqual(int(rows.localized_flag.sum()), self.bench.verdict["localized_rows"])

    def test_other_configurations_and_wrong_places_are_taken_or_told(self):
        by_name = opal.bench(DEMO, config=opal.read_deployment("default"))
        self.assertEqual(by_name.run.columns()["query_id"], self.bench.run.columns()["query_id"])
        with self.assertRaisesRegex(opal.Error, "nowhere"):
            opal.bench(str(self.folder / "nowhere"))

    def test_without_recorded_truth_nothing_is_judged(self):
        for ending in (".map.jsonld", ".info.json", ".queries.json", ".log.gz"):
            target = self.folder / f"place{ending}"
            if ending == ".map.jsonld":
                opal.read_map(MAP).write(str(target))
            else:
                target.symlink_to(DEMO + ending)
        bench = opal.bench(str(self.folder / "place"))
        self.assertIsNone(bench.verdict)
        self.assertIn("not judged", bench.summary)
        self.assertEqual(set(bench.columns()["success"]), {None})
        self.assertEqual(len(bench.run), len(self.bench.run))


if __name__ == "__main__":
    unittest.main()

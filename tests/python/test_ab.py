"""Results of `opal ab` as columns and frames."""

import csv
import json
import unittest

import opal
from recorded import DEMO, InFolder, scorers


class Experiments(InFolder):
    def computed(self):
        arms = [{"name": name, "overrides": {"scorers": scorers(kind)["scorers"]}}
                for name, kind in (("evidence", "opal:Evidence"), ("lack_of_fit", "opal:LackOfFit"))]
        experiment = {"@context": "urn:opal:v1", "@type": "opal:Experiment", "arms": arms, "sites": [{"prefix": DEMO}],
                      "metrics": ["success", "distance_to_success_m", "cpu_ms"]}
        (self.folder / "two.jsonld").write_text(json.dumps(experiment))
        self.opal("ab", "two.jsonld", "-o", "out")
        return opal.read_ab(str(self.folder / "out"))

    def test_cells_and_verdicts_are_those_of_the_program(self):
        results = self.computed()
        lines = [json.loads(line) for line in (self.folder / "out" / "results.jsonl").read_text().splitlines()]
        columns = results.columns()
        self.assertEqual(columns["query"], [line["query"] for line in lines])
        self.assertEqual(columns["success"], [line["values"]["success"] for line in lines])
        self.assertTrue(all(value > 0 for value in columns["cpu_ms"]))
        frame = results.frame()
        self.assertEqual(len(frame), 10)
        self.assertEqual(set(frame.groupby("arm").success.count()), {5})
        verdict = json.loads((self.folder / "out" / "verdict.json").read_text())
        self.assertEqual(results.sentences, [verdict[0]["sentence"]])
        rows = results.verdict_frame()
        self.assertEqual(list(rows.metric), ["success", "distance_to_success_m", "cpu_ms"])
        self.assertEqual(list(rows.p), [metric["p"] for metric in verdict[0]["metrics"]])
        self.assertEqual(list(rows.outcome), [metric["outcome"] for metric in verdict[0]["metrics"]])
        self.assertIn("10 cells", repr(results))

    def test_tables_for_papers_have_the_same_numbers_in_every_form(self):
        self.computed()
        paper = self.folder / "out" / "paper"
        for name in sorted(path.stem for path in paper.glob("*.csv")):
            with open(paper / f"{name}.csv", newline="", encoding="utf-8") as file:
                rows = list(csv.reader(file))
            markdown = [[cell.strip() for cell in line.strip("|\n").split(" |")]
                        for line in (paper / f"{name}.md").read_text().replace("\\", "").splitlines()]
            self.assertEqual(rows, [markdown[0], *markdown[2:]], name)
            self.assertEqual((paper / f"{name}.tex").read_text().count("\\\\\n"), len(rows), name)

    def test_what_is_no_finished_experiment_is_told(self):
        with self.assertRaisesRegex(opal.Error, "manifest.json: cannot be read .*expected the folder of a finished opal ab"):
            opal.read_ab(str(self.folder))
        self.computed()
        (self.folder / "out" / "results.jsonl").write_text("{}\nno\n")
        with self.assertRaisesRegex(opal.Error, "results.jsonl: line 2: is no JSON"):
            opal.read_ab(str(self.folder / "out"))


if __name__ == "__main__":
    unittest.main()

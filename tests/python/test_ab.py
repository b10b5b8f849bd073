"""Results of `opal ab` as columns and frames."""

import csv
import json
import unittest

import opal
from recorded import DEMO, ROOT, InFolder, scorers


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

    def test_a_bundle_has_the_files_of_classes_and_stays_as_it_was(self):
        example = ROOT / "docs" / "examples" / "python_scorer"
        document = json.loads((example / "python_scorer.jsonld").read_text())
        document.update(sites=[{"prefix": DEMO}], metrics=["success", "distance_to_success_m"])
        (self.folder / "likelihood.py").write_text((example / "likelihood.py").read_text())
        (self.folder / "classes.jsonld").write_text(json.dumps(document))
        self.opal("ab", "classes.jsonld", "-o", "out")
        self.opal("ab", "bundle", "classes.jsonld", "-o", "out", "--to", "bundle")
        (self.folder / "likelihood.py").unlink()
        for out in ("first", "second"):
            said = self.opal("ab", "repeat", "bundle", "-o", out)
            self.assertIn("every cell came out as in the bundle", said)
            self.assertIn("the verdict is that of the bundle", said)

    def test_what_is_no_finished_experiment_is_told(self):
        with self.assertRaisesRegex(opal.Error, "manifest.json: cannot be read .*expected the folder of a finished opal ab"):
            opal.read_ab(str(self.folder))
        self.computed()
        (self.folder / "out" / "results.jsonl").write_text("{}\nno\n")
        with self.assertRaisesRegex(opal.Error, "results.jsonl: line 2: is no JSON"):
            opal.read_ab(str(self.folder / "out"))


if __name__ == "__main__":
    unittest.main()

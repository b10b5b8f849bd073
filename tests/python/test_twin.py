"""A scorer that was written in Python and then in C++ gets the same verdict."""

import json
import os
import unittest

import opal
from recorded import DEMO, InFolder, scorers

TWIN_PLUGINS = os.environ["OPAL_TWIN_PLUGINS"]  # docs/examples/outside_scorer, built


class Twins(InFolder):
    def computed(self):
        """Evidence beside both, on a recorded hall and in generated buildings."""
        (self.folder / "twin.py").write_text("from opal.examples import Likelihood\n\n\nclass Twin(Likelihood):\n    pass\n")
        arms = [{"name": name, "overrides": scorers(kind)} for name, kind in
                (("evidence", "opal:Evidence"), ("in_python", "twin.py:Twin"), ("in_cpp", "acme:LikelihoodField"))]
        for arm in arms:
            arm["overrides"] = {"scorers": arm["overrides"]["scorers"]}
        arms[2]["plugins"] = TWIN_PLUGINS
        drives = [{"name": kind, "building": {"kind": kind, "size_m2": 300}, "buildings": 2, "drives": 2, "distance_m": 8}
                  for kind in ("office", "corridor")]
        experiment = {"@context": "urn:opal:v1", "@type": "opal:Experiment", "arms": arms, "sites": [{"prefix": DEMO}],
                      "simulated": drives, "metrics": ["success", "distance_to_success_m", "localized", "honest"]}
        (self.folder / "twins.jsonld").write_text(json.dumps(experiment))
        self.opal("ab", "twins.jsonld", "-o", "out")
        return opal.read_ab(str(self.folder / "out"))

    def test_both_get_the_same_verdict_number_by_number(self):
        results = self.computed()
        rows = results.verdict_frame()
        in_python, in_cpp = (rows[rows.arm == arm].drop(columns="arm").reset_index(drop=True)
                             for arm in ("in_python", "in_cpp"))
        self.assertEqual(len(in_python), 4)
        self.assertEqual(in_python.outcome.tolist(), in_cpp.outcome.tolist())
        for column in ("value", "difference", "low", "high", "p", "pairs"):
            for one, other in zip(in_python[column], in_cpp[column]):
                self.assertEqual(one is None, other is None, column)
                if one is not None:
                    self.assertAlmostEqual(one, other, places=6, msg=column)
        python_words, cpp_words = results.sentences
        self.assertEqual(python_words.replace("in_python", "in_cpp"), cpp_words)


if __name__ == "__main__":
    unittest.main()

"""Detectors, templates and scorers that are classes of Python: in the program and in the module."""

import concurrent.futures
import json
import pathlib
import subprocess
import sys
import unittest
import warnings

import numpy as np
import opal
import opal.plugin
from recorded import DEMO, LOG, MAP, ROOT, InFolder, scorers

EXAMPLE = ROOT / "docs" / "examples" / "python_scorer" / "likelihood.py"

BAD = '''
import numpy as np


class Raises:
    def score(self, hypotheses, observation, map):
        return self.other(hypotheses)

    def other(self, hypotheses):
        raise ValueError("nothing fits")


class WrongShape:
    def score(self, hypotheses, observation, map):
        return np.zeros(len(hypotheses) + 1)


class NotFinite:
    def score(self, hypotheses, observation, map):
        return np.full(len(hypotheses), np.nan)


class Vetoes:
    def score(self, hypotheses, observation, map):
        zeros = np.zeros(len(hypotheses))
        return zeros, {"a": zeros, "b": zeros + 1}, ["never here"] * len(hypotheses)


class Counts:
    """Says to a file how many hypotheses each call has."""

    def __init__(self, file):
        self.file = file

    def score(self, hypotheses, observation, map):
        with open(self.file, "a") as file:
            file.write(f"{len(hypotheses)}\\n")
        return map.likelihood_field(observation.points_at(hypotheses.poses)).sum(axis=1)


class NoMethod:
    pass


class CannotBeMade:
    def __init__(self):
        raise RuntimeError("no licence")

    def score(self, hypotheses, observation, map):
        return np.zeros(len(hypotheses))


class OtherThing:
    produces = ["opal:Column"]

    def detect(self, scan):
        return ["a feature"]
'''


class InProgramAndModule(InFolder):
    def setUp(self):
        super().setUp()
        (self.folder / "bad.py").write_text(BAD)
        (self.folder / "likelihood.py").write_text(EXAMPLE.read_text())

    def deployment(self, *types, options=None, **members):
        """A file; the options are those of the first scorer."""
        document = scorers(*types, **members)
        document["scorers"][0].update({"options": options} if options else {})
        document["matcher"] = {"@type": "opal:PointToLineMatcher"}
        (self.folder / "d.jsonld").write_text(json.dumps(document))
        return str(self.folder / "d.jsonld")

    def bench(self, *types, **options):
        return self.opal("bench", DEMO, "--config", self.deployment(*types, **options), "-o", "out")

    def localizer(self, *types, **options):
        lasers = [opal.read_laser(f"{DEMO}.info.json")]
        deployment = opal.read_deployment(self.deployment(*types, **options)).with_lasers(lasers)
        return opal.Localizer(deployment, opal.read_map(MAP)), opal.read_log(LOG).samples(lasers)


class Scorers(InProgramAndModule):
    def test_the_example_keeps_the_contract_of_scorers(self):
        self.assertEqual(opal.check_class(str(EXAMPLE) + ":Likelihood"), [])
        self.opal("plugins", "--check", str(EXAMPLE) + ":Likelihood")

    def test_the_example_localizes_and_answers_the_same_in_the_program_and_in_the_module(self):
        said = self.bench("likelihood.py:Likelihood")
        self.assertRegex(said.splitlines()[0], "success in 5 of 5 queries")
        bench = opal.bench(DEMO, config=opal.read_deployment(str(self.folder / "d.jsonld")))
        bench.run.write_results(str(self.folder / "results.csv"))
        self.assertEqual((self.folder / "results.csv").read_bytes(), (self.folder / "out" / "results.csv").read_bytes())

    def test_options_are_arguments_of_the_class_and_wrong_ones_are_told_with_file_and_place(self):
        deployment = self.deployment("likelihood.py:Likelihood", options={"sgima_m": 0.2})
        with self.assertRaisesRegex(opal.ConfigError,
                                    r"d\.jsonld: /scorers/0: likelihood\.py:Likelihood: .*TypeError.*sgima_m") as raised:
            opal.Localizer(opal.read_deployment(deployment), opal.read_map(MAP))
        said = self.opal("bench", DEMO, "--config", deployment, "-o", "out", exit_code=3)
        self.assertIn(str(raised.exception), said)

    def test_many_hypotheses_are_judged_in_one_call(self):
        file = str(self.folder / "counts.txt")
        localizer, samples = self.localizer("bad.py:Counts", options={"file": file})
        for sample in samples:
            localizer.update(sample)
        counts = [int(line) for line in pathlib.Path(file).read_text().splitlines()]
        self.assertGreater(max(counts), 20)
        self.assertEqual(localizer.plugin_failures, {})

    def test_what_a_class_raises_is_told_with_file_and_line_and_the_run_goes_on(self):
        said = self.bench("opal:Beams", "bad.py:Raises")
        line = BAD.splitlines().index('        raise ValueError("nothing fits")') + 1
        self.assertRegex(said, rf"bad\.py:Raises: skipped: .*bad\.py:{line}: ValueError: nothing fits")
        self.assertIn("success in 5 of 5 queries", said)
        self.assertEqual(said.count("nothing fits"), 1)
        count = json.loads((self.folder / "out" / "summary.json").read_text())["plugin_failures"]["bad.py:Raises"]
        self.assertGreater(count, 5)
        skipped = f"skipped: bad.py:Raises failed {count} times\n"
        self.assertIn(skipped, said)
        bench = opal.bench(DEMO, config=opal.read_deployment(str(self.folder / "d.jsonld")))
        self.assertEqual(bench.plugin_failures, {"bad.py:Raises": count})
        self.assertTrue(bench.summary.endswith(skipped))

    def test_scores_of_another_number_or_not_finite_are_counted(self):
        for name in ("WrongShape", "NotFinite"):
            localizer, samples = self.localizer("opal:Beams", f"bad.py:{name}")
            run = localizer.run(samples)
            self.assertGreater(localizer.plugin_failures[f"bad.py:{name}"], 0)
            self.assertTrue(run.last.is_localized)
        self.assertNotEqual(opal.check_class(str(self.folder / "bad.py:NotFinite")), [])

    def test_a_veto_ends_hypotheses_and_terms_are_recorded(self):
        events = []
        lasers = [opal.read_laser(f"{DEMO}.info.json")]
        deployment = opal.read_deployment(self.deployment("opal:Beams", "bad.py:Vetoes")).with_lasers(lasers)
        localizer = opal.Localizer(deployment, opal.read_map(MAP), events=events.append)
        localizer.update(next(opal.read_log(LOG).samples(lasers)))
        self.assertEqual(localizer.hypotheses, [])
        self.assertIn("never here", json.dumps(events))

    def test_a_class_that_cannot_be_used_is_told_before_the_run_begins(self):
        wrong = {"bad.py:NoMethod": "has no method score, expected a scorer", "bad.py:Nonesuch": "it has: CannotBeMade, ",
                 "none.py:Likelihood": "there is no file", "bad.py:CannotBeMade": r"bad\.py:\d+: RuntimeError: no licence"}
        for name, words in wrong.items():
            with self.assertRaisesRegex(opal.ConfigError, words):
                self.localizer(name)

    def test_a_file_that_python_cannot_read_is_told_with_its_line(self):
        (self.folder / "broken.py").write_text("import numpy\n\nclass A(:\n")
        with self.assertRaisesRegex(opal.ConfigError, r"broken\.py:3: SyntaxError"):
            self.localizer("broken.py:A")
        (self.folder / "broken.py").write_text("import no_such_module\n")
        with self.assertRaisesRegex(opal.ConfigError, r"broken\.py:1: ModuleNotFoundError"):
            self.localizer("broken.py:A")

    def test_a_class_is_no_matcher(self):
        deployment = self.deployment("opal:Beams")
        document = json.loads(pathlib.Path(deployment).read_text())
        document["matcher"] = {"@type": "likelihood.py:Likelihood"}
        with self.assertRaisesRegex(opal.ConfigError, "/matcher.*likelihood.py:Likelihood"):
            opal.Localizer(opal.make_deployment(document, deployment), opal.read_map(MAP))

    def test_opal_ab_forks_and_judges_and_refuses_results_of_a_class_that_was_changed(self):
        document = json.loads((EXAMPLE.parent / "python_scorer.jsonld").read_text())
        document["sites"] = [{"prefix": DEMO}]
        (self.folder / "ab.jsonld").write_text(json.dumps(document))
        said = self.opal("ab", "ab.jsonld", "-o", "ab", "--jobs", "2")
        self.assertIn("10 of 10 cells are finished", said)
        results = [json.loads(line) for line in (self.folder / "ab" / "results.jsonl").read_text().splitlines()]
        self.assertEqual(len(results), 10)
        self.assertNotIn("failed in a plugin", json.dumps(results))
        with open(self.folder / "likelihood.py", "a") as file:
            file.write("\n# another class\n")
        self.assertIn("sha256", self.opal("ab", "ab.jsonld", "-o", "ab", exit_code=3))


class DetectorsAndTemplates(InProgramAndModule):
    PARTS = {"detectors": [{"@type": "parts.py:Posts"}, {"@type": "opal:LineDetector"}],
             "patterns": [{"@type": "parts.py:Pair"}, {"@type": "opal:LinePair"}]}

    def setUp(self):
        super().setUp()
        page = (ROOT / "docs" / "python.md").read_text()
        parts = [page.split(f"<!-- file: {name} -->\n```python\n")[1].split("```")[0] for name in ("posts.py", "pair.py")]
        (self.folder / "parts.py").write_text("\n\n".join(parts))

    def test_those_of_the_page_keep_their_contracts(self):
        for name in ("Posts", "Pair"):
            with warnings.catch_warnings():
                warnings.simplefilter("error")  # numpy warns of what is not finite
                self.assertEqual(opal.check_class(str(self.folder / f"parts.py:{name}")), [])

    def test_they_run_in_the_program_beside_plugins(self):
        self.assertIn("success in 5 of 5 queries", self.bench("opal:Beams", **self.PARTS))

    def test_what_they_find_is_in_the_local_map(self):
        localizer, samples = self.localizer("opal:Beams", **self.PARTS)
        for sample in samples:
            localizer.update(sample)
        self.assertIn("opal:Column", {feature["type"] for feature in localizer.local_features})
        self.assertEqual(localizer.plugin_failures, {})

    def test_a_detector_of_what_the_map_does_not_hold_does_not_run(self):
        (self.folder / "other.py").write_text(
            "class Lamps:\n    produces = ['acme:Lamp']\n    def detect(self, scan): raise RuntimeError\n")
        parts = {"detectors": [{"@type": "other.py:Lamps"}, {"@type": "opal:LineDetector"}]}
        localizer, samples = self.localizer("opal:Beams", **parts)
        localizer.update(next(samples))
        self.assertEqual(localizer.plugin_failures, {})

    def test_what_is_no_feature_is_counted_by_its_class(self):
        parts = {"detectors": [{"@type": "bad.py:OtherThing"}, {"@type": "opal:LineDetector"}]}
        localizer, samples = self.localizer("opal:Beams", **parts)
        localizer.update(next(samples))
        self.assertEqual(localizer.plugin_failures, {"bad.py:OtherThing": 1})

    def test_a_wrong_feature_or_pattern_is_told(self):
        with self.assertRaisesRegex(ValueError, "numbers: 2 of a circle, expected 3: x, y, radius"):
            opal.Feature("acme:Post", "circle", [1, 2], [0.1, 0.1, 0.1])
        with self.assertRaisesRegex(ValueError, 'shape: "cube"'):
            opal.Feature("acme:Post", "cube", [1, 2], [0.1])
        with self.assertRaisesRegex(ValueError, "sigmas: 1 of a circle, expected 3"):
            opal.Feature("acme:Post", "circle", [1, 2, 3], [0.1])
        with self.assertRaisesRegex(ValueError, "sigmas: negative"):
            opal.Feature("acme:Post", "circle", [1, 2, 3], [0.1, -0.1, 0.1])
        with self.assertRaisesRegex(ValueError, "numbers: a radius of 0 or less"):
            opal.Feature("acme:Post", "circle", [1, 2, -3], [0.1, 0.1, 0.1])
        with self.assertRaisesRegex(ValueError, "numbers: not finite"):
            opal.Feature("acme:Post", "point", [1, float("nan")], [0.1, 0.1])
        with self.assertRaisesRegex(ValueError, '"larger", expected equal'):
            opal.Pattern([(1.0, 0.1, "larger")], [0, 0, 0])


class Threads(InProgramAndModule):
    def test_a_file_that_takes_its_time_is_loaded_once_and_whole_for_all_threads(self):
        slow = pathlib.Path(self.folder, "slow.py")
        slow.write_text("import time\ntime.sleep(0.3)\nclass Late: pass\n")
        with concurrent.futures.ThreadPoolExecutor(4) as threads:
            found = list(threads.map(opal.plugin.find, [f"{slow}:Late"] * 4))
        self.assertEqual(len(set(found)), 1)

    def test_a_scorer_in_python_does_not_block_other_threads_for_ever(self):
        words = ("import opal, threading; from recorded import *; lasers = [opal.read_laser(f'{DEMO}.info.json')]\n"
                 f"d = opal.read_deployment('{self.deployment('likelihood.py:Likelihood')}').with_lasers(lasers)\n"
                 "m, log, runs = opal.read_map(MAP), opal.read_log(LOG), []\n"
                 "def run(): runs.append(len(opal.Localizer(d, m).run(log.samples(lasers))))\n"
                 "threads = [threading.Thread(target=run) for _ in range(2)]\n"
                 "[t.start() for t in threads]; [t.join() for t in threads]; assert runs[0] == runs[1] > 0, runs")
        done = subprocess.run([sys.executable, "-c", words], timeout=120, cwd=ROOT / "tests" / "python")
        self.assertEqual(done.returncode, 0)


if __name__ == "__main__":
    unittest.main()

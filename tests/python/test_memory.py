"""Scorers in Python that remember: a memory for each hypothesis."""

import pathlib
import unittest

import opal
from recorded import DEMO, ROOT
from test_plugins import InProgramAndModule

CLASSES = '''
import numpy as np


class Steps:
    """Remembers how many scans each hypothesis has met."""

    def __init__(self, file="", seen=True):
        self.file, self.seen = file, seen

    def new_memory(self, map):
        return {"scans": 0.0, "faces": len(map.features)}

    def score(self, hypotheses, observation, map):
        assert len(hypotheses.memories) == len(hypotheses)
        if self.file:
            with open(self.file, "a") as file:
                file.write(f"{len(hypotheses)} {max(memory['scans'] for memory in hypotheses.memories)}\\n")
        near = map.likelihood_field(observation.points_at(hypotheses.poses)).sum(axis=1) / max(1, len(observation.points))
        return 10 * near, {}, [], [1.0] * (len(hypotheses) if self.seen else 1)

    def remember(self, memory, seen, weight):
        memory["scans"] += weight * seen

    def fade(self, memory, weight):
        return {**memory, "scans": memory["scans"] * (1 - 0.1 * weight)}


class WritesInScore(Steps):
    def score(self, hypotheses, observation, map):
        scores = [memory["scans"] for memory in hypotheses.memories]
        for memory in hypotheses.memories:
            memory["scans"] += 1
        return scores


class NoRemember:
    def new_memory(self, map):
        return 0.0

    def score(self, hypotheses, observation, map):
        return np.zeros(len(hypotheses))
'''


class Memories(InProgramAndModule):
    def setUp(self):
        super().setUp()
        (self.folder / "memory.py").write_text(CLASSES)
        page = (ROOT / "docs" / "python.md").read_text()
        example = page.split("<!-- file: new_faces.py -->\n```python\n")[1].split("```")[0]
        (self.folder / "new_faces.py").write_text(example)

    def test_a_memory_grows_with_its_hypothesis_and_all_are_judged_in_one_call(self):
        file = str(self.folder / "steps.txt")
        localizer, samples = self.localizer("memory.py:Steps", options={"file": file})
        run = localizer.run(samples)
        self.assertEqual(localizer.plugin_failures, {})
        self.assertGreater(run.last.probability, 0.99)
        calls = [[float(word) for word in line.split()] for line in pathlib.Path(file).read_text().splitlines()]
        self.assertEqual(calls[0][1], 0)
        self.assertGreater(max(count for count, _ in calls), 20)
        self.assertGreater(max(scans for _, scans in calls), 1)

    def test_memories_keep_the_contract_of_scorers_or_break_it(self):
        self.assertEqual(opal.check_class(str(self.folder / "new_faces.py:NewFaces")), [])
        self.assertEqual(opal.check_class(str(self.folder / "memory.py:Steps")), [])
        broken = opal.check_class(str(self.folder / "memory.py:WritesInScore"))
        self.assertIn("another score when the same memory is used again", " ".join(broken))

    def test_what_is_wrong_with_a_memory_is_told(self):
        with self.assertRaisesRegex(opal.ConfigError, "has new_memory, but no method remember, expected both or none"):
            self.localizer("memory.py:NoRemember")
        said = self.opal("bench", DEMO, "--config", self.deployment("memory.py:Steps", options={"seen": False}), "-o", "out")
        self.assertRegex(said, r"Steps\.score: 1 things seen, expected \d+: one per hypothesis")

    def test_the_scorer_with_a_memory_of_the_page_localizes_alike_in_the_program_and_in_the_module(self):
        said = self.bench("new_faces.py:NewFaces")
        self.assertIn("success in 5 of 5 queries", said)
        bench = opal.bench(DEMO, config=opal.read_deployment(str(self.folder / "d.jsonld")))
        bench.run.write_results(str(self.folder / "results.csv"))
        self.assertEqual((self.folder / "results.csv").read_bytes(), (self.folder / "out" / "results.csv").read_bytes())


if __name__ == "__main__":
    unittest.main()

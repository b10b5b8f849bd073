"""kill -9 at a random moment: what a program has told as written is there and whole, what it replaces stays until then, and the
next run does its work.

OPAL_KILLS says how often each program is killed (3 in the suite; 125 give a thousand kills, in half an hour).
"""

import json
import os
import random
import signal
import time

from runs import CONFIG, CORRIDOR, RunTest

KILLS = int(os.environ.get("OPAL_KILLS", "3"))
EXPERIMENT = {
    "@context": "urn:opal:v1", "@type": "opal:Experiment", "name": "killed", "baseline": "few",
    "arms": [{"name": name, "overrides": {"stages": {"search": {"candidates": count}}}} for name, count in (("few", 10), ("many", 30))],
    "sites": [{"prefix": CORRIDOR}], "metrics": ["success", "distance_to_success_m"], "limits": {"cell_s": 60, "memory_mb": 1000}}


class Killed(RunTest):
    def setUp(self):
        super().setUp()
        self.random = random.Random(self.id())

    def contents(self, names):
        """Of files below the folder; none of a file that is not there."""
        return {name: file.read_bytes() if (file := self.folder / name).exists() else None for name in names}

    def kill_once(self, words, at_most_s):
        """@return whether it was killed before its end, and what it had said."""
        process = self.start(*words)
        time.sleep(self.random.uniform(0, at_most_s))
        process.send_signal(signal.SIGKILL)
        said, _ = process.communicate()
        return process.returncode == -signal.SIGKILL, said

    def timed(self, words):
        begin_s = time.monotonic()
        self.run_to_its_end(*words)
        return time.monotonic() - begin_s

    def kill_often(self, words, names):
        """@param words  the program, which writes the files `names`, each whole or not at all."""
        old = {name: f"was here before {name}".encode() for name in names}
        takes_s = self.timed(words)
        new, killed = self.contents(names), 0
        for _ in range(KILLS):
            for name, text in old.items():
                (self.folder / name).write_bytes(text)
            was_killed, said = self.kill_once(words, 1.2 * takes_s)
            killed += was_killed
            for name, text in self.contents(names).items():
                allowed = {"as it was": old[name], "as told": new[name]}
                if "written: " in said:
                    del allowed["as it was"]
                self.assertIn(text, allowed.values(), f"{name} is neither of {list(allowed)}; it said: {said}")
        self.run_to_its_end(*words)
        self.assertEqual(self.contents(names), new, "the next run gives something else")
        self.assertGreater(killed, 0, "every run ended before it was killed")

    def test_an_import_leaves_the_map_that_was_there_or_a_whole_one(self):
        self.kill_often(["map", "import", CORRIDOR + ".map.yaml", "-o", "map.jsonld"], ["map.jsonld"])

    def test_a_joined_map_is_whole_or_the_one_that_was_there(self):
        self.kill_often(["map", "join", CORRIDOR + ".map.yaml", "--copies", "20", "-o", "map.jsonld"], ["map.jsonld"])

    def test_files_of_a_simulated_drive_are_whole(self):
        self.run_to_its_end("map", "import", CORRIDOR + ".map.yaml", "-o", "corridor.jsonld")
        names = [f"place.{kind}" for kind in ("log.gz", "gt.csv", "info.json", "queries.json", "map.jsonld")]
        self.kill_often(["simulate", "corridor.jsonld", "-o", "place", "--distance", "4"], names)

    def test_what_was_learned_is_whole(self):
        self.run_to_its_end("map", "import", CORRIDOR + ".map.yaml", "-o", "corridor.jsonld")
        self.kill_often(["learn", "corridor.jsonld", CORRIDOR + ".log.gz", "--config", CONFIG, "-o", "learned.jsonld", "--evidence",
                         "evidence.json"], ["learned.jsonld", "evidence.json"])

    def test_a_large_map_is_prepared_whole_or_once_more(self):
        """The file that is mapped into memory: what a killed program leaves never changes an answer."""
        self.run_to_its_end("map", "join", CORRIDOR + ".map.yaml", "--copies", "80", "-o", "large.jsonld")
        words = ["localize", CONFIG, CORRIDOR + ".log.gz", "--map", "large.jsonld", "-o", "out"]
        os.environ["OPAL_PREPARED_CACHE"] = str(self.folder / "prepared")
        self.addCleanup(os.environ.pop, "OPAL_PREPARED_CACHE")
        takes_s = self.timed(words)
        new, prepared = self.contents(["out/results.csv"]), self.prepared()
        self.assertTrue(prepared, "the map is too small to be prepared")
        for _ in range(KILLS):
            for file in (self.folder / "prepared").iterdir():
                file.unlink()
            self.kill_once(words, 0.8 * takes_s)
            self.assertLessEqual(self.prepared().items(), prepared.items())
            self.run_to_its_end(*words)
            self.assertEqual(self.contents(["out/results.csv"]), new)
            self.assertEqual(self.prepared(), prepared)

    def prepared(self):
        """Files that another program would open."""
        return {file.name: file.read_bytes() for file in (self.folder / "prepared").glob("*") if file.suffix != ".part"}

    def expect_marked_or_whole(self, names, new):
        """A run that was killed is marked in its folder, or its results are whole."""
        marker = self.marker()
        if marker is None:
            self.assertEqual(self.contents(names), new)
        else:
            self.assertNotIn("ending", marker)

    def kill_runs(self, words):
        names = ["out/results.csv"]
        takes_s = self.timed(words)
        new = self.contents(names)
        for _ in range(KILLS):
            _, said = self.kill_once(words, 1.2 * takes_s)
            self.expect_marked_or_whole(names, new)
            if "written" in said:
                self.assertEqual(self.contents(names), new, said)
        self.run_to_its_end(*words)
        self.assertEqual(self.contents(names), new, "the next run gives something else")
        self.assertIsNone(self.marker())

    def test_a_run_of_localize_is_whole_or_marked(self):
        self.kill_runs(["localize", CONFIG, CORRIDOR + ".log.gz", "--map", CORRIDOR + ".map.yaml", "-o", "out"])

    def test_a_run_of_bench_is_whole_or_marked(self):
        self.kill_runs(["bench", CORRIDOR, "-o", "out"])

    def test_an_experiment_keeps_every_cell_that_it_has_counted(self):
        (self.folder / "killed.jsonld").write_text(json.dumps(EXPERIMENT))
        words = ["ab", "killed.jsonld", "--jobs", "2", "-o"]
        takes_s = self.timed([*words, "whole"])
        whole = (self.folder / "whole/results.jsonl").read_bytes()
        cells = 0
        for _ in range(KILLS):
            self.kill_once([*words, "out"], 0.7 * takes_s)
            told = self.cells_of("out")
            self.assertGreaterEqual(told, cells, "cells that were there are gone")
            cells = told
        self.run_to_its_end(*words, "out")
        self.assertEqual((self.folder / "out/results.jsonl").read_bytes(), whole)

    def cells_of(self, out):
        """Cells that are in the journals."""
        lines = [line for file in (self.folder / out).glob("journals/*") for line in file.read_text().splitlines(keepends=True)]
        return sum(line.endswith("\n") and "cell" in json.loads(line) for line in lines)

"""Ctrl-C and SIGTERM in the middle of a run."""

import json
import signal
import time

from runs import CONFIG, CORRIDOR, MALAGA, RunTest, TREE

GEMINI = str(TREE / "maps" / "gemini.jsonld")


class Interruption(RunTest):
    def begin_long_run(self):
        process = self.start(*self.long_localize())
        self.wait_until("three queries have begun", lambda: self.starts_of() > 3, process)
        return process

    def expect_interrupted(self, ending, out="out"):
        exit_code, said, errors = ending
        self.assertEqual(exit_code, 130, said + errors)
        self.assertIn(f"opal: interrupted (SIGINT): {out} holds what was finished", errors)
        self.assertEqual(self.marker(out)["ending"], "was interrupted (SIGINT)")

    def test_localize_ends_with_the_results_of_the_queries_that_were_finished(self):
        ending = self.interrupt(self.begin_long_run(), signal.SIGINT)
        self.expect_interrupted(ending)
        rows = self.rows()
        queries = list(dict.fromkeys(row["query_id"] for row in rows))
        starts = [event for event in self.events() if event["event"] == "start"]
        self.assertEqual(queries, [f"q{k}" for k in range(len(starts) - 1)])
        counts = {query: sum(row["query_id"] == query for row in rows) for query in queries}
        self.assertEqual(len(set(counts.values())), 1, "a query in the results is not whole")
        self.assertIn(f"{len(queries)} of 2000 queries were finished", ending[1])
        for name in ("trajectory.tum", "first_scan.svg", "picture.svg", "picture.png"):
            self.assertTrue((self.folder / "out" / name).stat().st_size > 0, name)

    def test_sigterm_ends_a_run_the_same_way(self):
        exit_code, said, errors = self.interrupt(self.begin_long_run(), signal.SIGTERM)
        self.assertEqual(exit_code, 143, said + errors)
        self.assertEqual(self.marker()["ending"], "was interrupted (SIGTERM)")
        self.events()

    def test_readers_show_an_interrupted_run_and_say_so(self):
        self.interrupt(self.begin_long_run(), signal.SIGINT)
        note = "this run was not finished: opal localize (process "
        for reader in (["explain", "out"], ["view", "out"]):
            said = self.run_to_its_end(*reader)
            self.assertIn(note, said.stderr)
            self.assertIn("was interrupted (SIGINT)", said.stderr)

    def test_a_recorded_log_in_real_time_ends_with_the_scans_that_it_had(self):
        process = self.start("localize", CONFIG, MALAGA + ".log.gz", "--serve=0", "--speed", "20", "-o", "out")
        self.wait_until("the events have some blocks", lambda: (self.folder / "out" / "events.jsonl").exists()
                        and (self.folder / "out" / "events.jsonl").stat().st_size > 200000, process)
        self.expect_interrupted(self.interrupt(process, signal.SIGINT))
        rows = self.rows()
        self.assertGreater(len(rows), 0)
        self.assertLess(len(rows), 225)
        self.events()

    def test_a_track_that_is_being_smoothed_ends_with_the_trajectory_as_it_was_tracked(self):
        self.run_to_its_end("simulate", GEMINI, "-o", "long", "--drives", "1", "--distance", "300")
        process = self.start("track", "default", "long.log.gz", "--info", "long.info.json", "--map", "long.map.jsonld",
                             "--truth", "long.gt.csv", "--offline", "-o", "out")
        self.wait_until("it was tracked", (self.folder / "out" / "picture.png").exists, process)
        self.expect_interrupted(self.interrupt(process, signal.SIGINT))
        self.assertGreater(len(self.rows()), 1000)
        self.assertTrue((self.folder / "out" / "deviations.json").exists())
        self.assertFalse((self.folder / "out" / "truth.csv").exists())

    def test_bench_ends_with_whole_queries_and_calibration_says_so(self):
        prefix = self.folder / "site"
        for ending in (".log.gz", ".info.json", ".gt.csv"):
            (self.folder / ("site" + ending)).symlink_to(CORRIDOR + ending)
        self.run_to_its_end("map", "import", CORRIDOR + ".map.yaml", "-o", "site.map.jsonld")
        self.many_queries(20000).rename(self.folder / "site.queries.json")
        process = self.start("bench", prefix, "-o", "out")
        self.wait_until("it has begun", lambda: self.marker() is not None, process)
        # Some queries take less than a second.
        try:
            process.wait(timeout=3)
        except Exception:
            pass
        self.expect_interrupted(self.interrupt(process, signal.SIGINT))
        finished = json.loads((self.folder / "out" / "summary.json").read_text())["queries"]
        rows = self.rows()
        self.assertEqual(len({row["query_id"] for row in rows}), finished)
        if finished > 0:
            self.assertIn("this run was not finished", self.run_to_its_end("calibration", "out").stderr)

    def test_track_ends_with_the_windows_that_were_finished(self):
        process = self.start("track", CONFIG, CORRIDOR + ".log.gz", "--map", CORRIDOR + ".map.yaml", "--truth",
                             CORRIDOR + ".gt.csv", "--queries", self.many_queries(20000), "-o", "out")
        self.wait_until("it has begun", lambda: self.marker() is not None, process)
        self.expect_interrupted(self.interrupt(process, signal.SIGINT))
        windows = json.loads((self.folder / "out" / "summary.json").read_text())["windows"]
        self.assertLess(len(windows), 20000)

    def test_drive_ends_with_the_drives_that_were_finished(self):
        process = self.start("drive", TREE / "configs" / "default.jsonld", GEMINI, "--runs", "1000", "-o", "out",
                             "--record", "recorded")
        self.wait_until("a drive is drawn", lambda: (self.folder / "out" / "drive_1.png").exists(), process)
        self.expect_interrupted(self.interrupt(process, signal.SIGINT))
        summary = json.loads((self.folder / "out" / "summary.json").read_text())
        self.assertEqual(summary["drives"], len(summary["runs"]))
        self.assertGreater(summary["drives"], 0)
        recorded = json.loads((self.folder / "recorded.queries.json").read_text())
        self.assertEqual(len(recorded["queries"]), summary["drives"])

    def test_an_experiment_that_is_stopped_before_its_first_run_says_so(self):
        process = self.start("experiment", "thesis3", "-o", "out", "--seeds", "500", "--jobs", "1")
        self.wait_until("it has begun", lambda: self.marker() is not None, process)
        self.expect_interrupted(self.interrupt(process, signal.SIGINT))

    def test_a_second_ctrl_c_ends_a_run_at_once(self):
        process = self.start("experiment", "thesis3", "-o", "out", "--seeds", "1", "--jobs", "1", "--duration", "36000")
        self.wait_until("the first drive is under way", lambda: self.computed_s(process) > 4, process)
        while process.poll() is None:  # the first of them waits for the drive, which takes minutes
            process.send_signal(signal.SIGINT)
            time.sleep(0.1)
        self.assertEqual(process.returncode, -signal.SIGINT)
        self.assertNotIn("ending", self.marker())

    def test_an_interrupted_run_is_finished_by_running_it_again(self):
        self.interrupt(self.begin_long_run(), signal.SIGINT)
        self.run_to_its_end("localize", CONFIG, CORRIDOR + ".log.gz", "--map", CORRIDOR + ".map.yaml", "-o", "out")
        self.assertIsNone(self.marker())

"""Two programs and one folder; what an earlier run left."""

import signal

from runs import CONFIG, CORRIDOR, RunTest

LOCALIZE = ["localize", CONFIG, CORRIDOR + ".log.gz", "--map", CORRIDOR + ".map.yaml", "-o", "out"]


class SharedFolder(RunTest):
    def begin_long_run(self):
        first = self.start(*self.long_localize())
        self.wait_until("two queries have begun", lambda: self.starts_of() > 2, first)
        return first

    def test_the_second_of_two_runs_is_told_who_writes_into_the_folder(self):
        first = self.begin_long_run()
        second = self.run_to_its_end(*LOCALIZE, expected=5)
        self.assertIn(f"opal: out: opal localize (process {first.pid} on ", second.stderr)
        self.assertIn("writes into this folder; wait for its end, or give another folder", second.stderr)
        self.assertIn(", since 20", second.stderr)

    def test_the_first_of_two_runs_goes_on_undisturbed(self):
        first = self.begin_long_run()
        for command in (LOCALIZE, ["bench", CORRIDOR, "-o", "out"], ["drive", CONFIG, CORRIDOR + ".map.yaml", "-o", "out"]):
            self.run_to_its_end(*command, expected=5)
        self.interrupt(first, signal.SIGINT)
        events = self.events()
        self.assertEqual(sum(event["event"] == "run" for event in events), 1)
        keyframes = [event["keyframe"] for event in events if event["event"] == "keyframe"]
        self.assertTrue(all(a < b or b <= 1 for a, b in zip(keyframes, keyframes[1:])), "keyframes of two runs are mixed")

    def test_a_folder_is_free_again_when_its_program_was_killed(self):
        first = self.begin_long_run()
        first.kill()
        first.communicate()
        self.run_to_its_end(*LOCALIZE)
        self.assertIsNone(self.marker())

    def test_a_reader_says_that_a_run_still_goes_on(self):
        first = self.begin_long_run()
        said = self.run_to_its_end("explain", "out")
        self.assertIn(f"this run is not finished: opal localize (process {first.pid}", said.stderr)
        self.assertIn("still writes", said.stderr)

    def test_a_reader_says_that_a_run_was_killed(self):
        first = self.begin_long_run()
        first.kill()
        first.communicate()
        said = self.run_to_its_end("view", "out")
        self.assertIn("this run was not finished", said.stderr)
        self.assertIn("was killed", said.stderr)

    def test_a_finished_run_has_no_mark(self):
        self.run_to_its_end(*LOCALIZE)
        self.assertIsNone(self.marker())
        self.assertNotIn("finished", self.run_to_its_end("explain", "out").stderr)

    def test_nothing_of_an_earlier_run_stands_beside_new_events(self):
        self.run_to_its_end(*LOCALIZE)
        self.run_to_its_end("view", "out")
        (self.folder / "out" / "notes.txt").write_text("mine\n")
        old = {file.name: file.stat().st_ino for file in (self.folder / "out").iterdir() if file.name != "notes.txt"}
        self.assertIn("view.html", old)
        first = self.begin_long_run()
        first.kill()
        first.communicate()
        names = {file.name for file in (self.folder / "out").iterdir()}
        self.assertNotIn("view.html", names)
        self.assertNotIn("picture.svg", names)
        self.assertNotIn("results.csv", names)
        self.assertEqual((self.folder / "out" / "notes.txt").read_text(), "mine\n")

    def test_wrong_input_leaves_the_results_of_the_earlier_run(self):
        self.run_to_its_end(*LOCALIZE)
        self.run_to_its_end("localize", CONFIG, "nowhere.log.gz", "-o", "out", expected=3)
        self.assertTrue((self.folder / "out" / "results.csv").exists())
        self.assertIsNone(self.marker())

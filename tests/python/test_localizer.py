"""The localizer step by step: the answers of `opal localize`, to the byte."""

import json
import math
import threading
import unittest

import numpy as np
import opal
from recorded import LOG, MAP, InFolder


def row(query, stamp, pose, estimate):
    """A row of results.csv as the program writes it."""
    numbers = ",".join(f"{number:.9f}" for number in (stamp, *pose))
    flag = int(estimate.is_localized)
    return f"{query},{numbers},{flag},{estimate.probability:.9f},{estimate.none:.9f},{estimate.status}"


def placed(pose, mount):
    """The laser's pose, of the robot's: as opal::Pose2 computes it."""
    x, y, heading = map(float, pose)
    cos, sin = math.cos(heading), math.sin(heading)
    turned = heading + mount[2]
    wrapped = math.fmod(turned + math.pi, 2 * math.pi)
    return (x + (cos * mount[0] - sin * mount[1]), y + (sin * mount[0] + cos * mount[1]),
            wrapped + math.pi if wrapped < 0 else wrapped - math.pi)


class Localizing(InFolder):
    @classmethod
    def setUpClass(cls):
        cls.map = opal.read_map(MAP)
        cls.deployment = opal.read_deployment("malaga")
        cls.log = opal.read_log(LOG, cls.deployment)
        cls.lasers = cls.log.lasers(cls.deployment)

    def localizer(self, **options):
        return opal.Localizer(self.deployment.with_lasers(self.lasers), self.map, **options)

    def program_results(self):
        self.opal("localize", "malaga", LOG, "--map", MAP, "-o", "out")
        return (self.folder / "out" / "results.csv").read_text()

    def test_a_run_writes_the_results_of_the_program(self):
        run = self.localizer().run(self.log.samples(self.lasers))
        run.write_results(str(self.folder / "results.csv"))
        self.assertEqual((self.folder / "results.csv").read_text(), self.program_results())
        self.assertEqual(run.trajectory.shape, (len(run), 4))
        tum = [line.split() for line in (self.folder / "out" / "trajectory.tum").read_text().splitlines()]
        np.testing.assert_allclose([[float(word) for word in line[:3]] for line in tum], run.trajectory[:, :3], atol=1e-6)

    def test_step_by_step_gives_the_same_answers(self):
        localizer, mount = self.localizer(), self.lasers[0].mount
        rows = []
        for sample in self.log.samples(self.lasers):
            localizer.update(sample)
            estimate = localizer.estimate_at(sample.stamp_s, sample.odometry)
            if estimate.pose is not None:
                rows.append(row("run", sample.stamp_s, placed(estimate.pose, mount), estimate))
        self.assertEqual("\n".join(rows), "\n".join(self.program_results().splitlines()[1:]))

    def test_scans_of_numbers_find_the_same_place(self):
        localizer = self.localizer()
        scans = [scan for scan in self.log.raw_scans() if scan.odometry is not None]
        for scan in scans:
            estimate = localizer.update(scan.ranges_m, scan.odometry, scan.stamp_s) or estimate
        whole = self.localizer().run(self.log.samples(self.lasers))
        self.assertTrue(estimate.is_localized)
        np.testing.assert_allclose(estimate.pose[:2], whole.last.pose[:2], atol=0.3)

    def test_an_answer_names_what_it_rests_on(self):
        localizer = self.localizer()
        run = localizer.run(self.log.samples(self.lasers))
        best = localizer.hypotheses[0]
        self.assertTrue(run.last.is_localized)
        self.assertEqual(localizer.reasons(run.last), "")
        self.assertGreater(run.last.probability, 0.9)
        self.assertEqual(run.last.covariance.shape, (3, 3))
        self.assertTrue(np.all(np.linalg.eigvalsh(run.last.covariance) > 0))
        on_map = best.associations[best.associations[:, 1] >= 0]
        pairs = localizer.associations
        self.assertGreater(len(pairs), 2)
        self.assertLessEqual(len(pairs), len(on_map))
        ids = {feature["id"] for feature in localizer.local_features}
        for pair in pairs:
            self.assertIn(pair.local_feature, ids)
            self.assertIn(pair.feature, [feature.id for feature in self.map.features])
            self.assertLess(pair.off_m, 1)
        self.assertEqual(list(localizer.scores(best.id)), self.deployment.scorers)

    def test_before_it_is_localized_it_says_why_not(self):
        localizer = self.localizer()
        for sample in self.log.samples(self.lasers):
            estimate = localizer.update(sample)
            if estimate and not estimate.is_localized:
                break
        self.assertEqual(localizer.reasons(estimate).split(":")[0], "not localized yet, it waits for more evidence")
        self.assertNotEqual(localizer.why, "")

    def test_reset_forgets_and_the_same_run_gives_the_same_rows(self):
        localizer = self.localizer()
        first = localizer.run(self.log.samples(self.lasers)).columns()
        again = localizer.run(self.log.samples(self.lasers)).columns()
        for name in first:
            np.testing.assert_array_equal(first[name], again[name])
        localizer.reset()
        self.assertEqual(localizer.hypotheses, [])

    def test_events_come_as_dicts_and_a_file_has_those_of_the_program(self):
        events = []
        localizer = self.localizer(events=events.append)
        run = localizer.run(self.log.samples(self.lasers))
        self.localizer(events=str(self.folder / "events.jsonl")).run(self.log.samples(self.lasers))
        written = list(opal.read_events(str(self.folder / "events.jsonl")))
        self.assertEqual([event["event"] for event in events], [event["event"] for event in written])
        self.assertEqual([event["event"] for event in events[:3]], ["run", "map", "start"])
        self.assertEqual(sum(event["event"] == "estimate" for event in events), len(run.cpu_ms))
        self.program_results()
        of_program = list(opal.read_events(str(self.folder / "out")))
        without_costs = [[e for e in stream if e["event"] not in ("run", "cost")] for stream in (written, of_program)]
        self.assertEqual(without_costs[0], without_costs[1])

    def test_what_a_listener_raises_comes_out_of_the_update_and_the_run_can_go_on(self):
        def listen(event):
            if event["event"] == "estimate":
                raise KeyError("mine")

        localizer = self.localizer(events=listen)
        samples = self.log.samples(self.lasers)
        with self.assertRaisesRegex(KeyError, "mine"):
            localizer.update(next(samples))
        self.assertGreater(len(localizer.hypotheses), 0)

    def test_a_listener_cannot_ask_in_the_middle_of_an_update(self):
        localizer = self.localizer(events=lambda event: event["event"] == "estimate" and localizer.hypotheses)
        with self.assertRaisesRegex(RuntimeError, "in the middle of an update"):
            localizer.update(next(self.log.samples(self.lasers)))

    def test_other_threads_run_during_an_update(self):
        counted, done = [0], threading.Event()

        def count():
            while not done.is_set():
                counted[0] += 1

        counter = threading.Thread(target=count)
        counter.start()
        before = counted[0]
        self.localizer().run(self.log.samples(self.lasers))
        after = counted[0]
        done.set()
        counter.join()
        self.assertGreater(after, before + 100)

    def test_a_hint_is_looked_at(self):
        localizer = self.localizer()
        localizer.hint([1e9, 0, 0])
        estimate = localizer.update(next(self.log.samples(self.lasers)))
        self.assertIn(estimate.status, ("searching", "ambiguous"))

    def test_a_picture_has_the_map_and_the_scan(self):
        from opal import drawing

        localizer = self.localizer()
        samples = list(self.log.samples(self.lasers))
        run = localizer.run(self.log.samples(self.lasers))
        ax = drawing.draw_answer(localizer, run.last, samples[-1].scan)
        drawing.draw_run(run, ax)
        self.assertEqual(len(ax.collections[0].get_segments()), len(self.map.segments()))
        self.assertIn("localized", ax.get_title())
        ax.figure.savefig(self.folder / "picture.png")

    def test_importing_opal_imports_neither_pandas_nor_matplotlib(self):
        import subprocess
        import sys

        words = "import opal, opal.drawing, sys; sys.exit('pandas' in sys.modules or 'matplotlib' in sys.modules)"
        self.assertEqual(subprocess.run([sys.executable, "-c", words]).returncode, 0)

    def test_a_deployment_document_is_a_dict(self):
        with open(opal.shipped_file("configs/malaga.jsonld")) as file:
            document = json.load(file)
        deployment = opal.make_deployment(document, opal.shipped_file("configs/malaga.jsonld"))
        self.assertEqual(deployment.map, self.deployment.map)
        self.assertEqual(deployment.scorers, ["opal:Beams"])


if __name__ == "__main__":
    unittest.main()

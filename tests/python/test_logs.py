"""Recorded logs as scans with odometry."""

import unittest

import numpy as np
import opal
from recorded import DEMO, LOG


class Logs(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.log = opal.read_log(LOG)
        cls.lasers = [opal.read_laser(f"{DEMO}.info.json")]

    def test_samples_come_by_increasing_stamp_with_scan_and_odometry(self):
        stamps = []
        for sample in self.log.samples(self.lasers):
            stamps.append(sample.stamp_s)
            self.assertEqual(sample.odometry.shape, (3,))
            self.assertEqual(len(sample.views), 1)
        self.assertEqual(len(stamps), len(self.log.raw_scans()))
        self.assertTrue(np.all(np.diff(stamps) > 0))

    def test_a_window_has_the_samples_of_its_time(self):
        first = self.log.raw_scans()[0].stamp_s
        window = self.log.samples(self.lasers, from_s=first + 5, to_s=first + 10)
        stamps = np.array([sample.stamp_s for sample in window])
        self.assertGreater(len(stamps), 3)
        self.assertTrue(np.all((stamps >= first + 5) & (stamps <= first + 10)))

    def test_a_scan_has_its_points_where_ranges_and_bearings_say(self):
        scan = next(self.log.samples(self.lasers)).scan
        expected = scan.ranges_m[:, None] * np.stack([np.cos(scan.bearings_rad), np.sin(scan.bearings_rad)], axis=1)
        np.testing.assert_allclose(scan.points, expected, atol=1e-9)
        self.assertTrue(np.all(np.diff(scan.bearings_rad) > 0))
        self.assertEqual(len(scan) + len(scan.free_bearings_rad) + scan.invalid, self.lasers[0].beams)

    def test_raw_scans_have_what_was_recorded(self):
        scans = self.log.raw_scans()
        self.assertEqual(scans[0].ranges_m.dtype, np.float32)
        self.assertEqual(scans[0].ranges_m.shape, (self.lasers[0].beams,))
        self.assertEqual(self.log.odometry.shape[1], 4)

    def test_a_log_outlives_its_name_in_python_while_it_is_replayed(self):
        samples = opal.read_log(LOG).samples(self.lasers)
        self.assertEqual(sum(1 for _ in samples), len(self.log.raw_scans()))
        self.assertEqual(samples.progress, 1)
        with self.assertRaises(StopIteration):
            next(samples)

    def test_a_scan_of_numbers_is_the_scan_of_the_log(self):
        raw, laser = self.log.raw_scans()[0], self.lasers[0]
        sample = laser.sample(raw.ranges_m, [0, 0, 0], raw.stamp_s)
        recorded = next(self.log.samples(self.lasers))
        self.assertEqual(recorded.stamp_s, raw.stamp_s)
        np.testing.assert_array_equal(sample.scan.points, recorded.scan.points)

    def test_ranges_that_are_no_ranges_are_counted(self):
        laser = opal.Laser(beams=7, angle_min_rad=-0.3, angle_increment_rad=0.1, range_max_m=30, no_return_m=80)
        scan = laser.sample([np.nan, 0, -1, 2, np.inf, 50, 81], [0, 0, 0], 1).scan
        self.assertEqual((len(scan), len(scan.free_bearings_rad), scan.invalid), (1, 3, 3))
        np.testing.assert_allclose(scan.points, [[2, 0]], atol=1e-9)

    def test_an_empty_scan_is_a_scan_and_a_longer_one_is_of_another_laser(self):
        laser = opal.Laser(beams=3)
        self.assertEqual(laser.sample([], [0, 0, 0], 1).scan.points.shape, (0, 2))
        with self.assertRaisesRegex(ValueError, "ranges_m: 5 numbers, expected 3"):
            laser.sample([1.0] * 5, [0, 0, 0], 1)


if __name__ == "__main__":
    unittest.main()

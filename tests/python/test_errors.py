"""Wrong input: the words of the program, as exceptions of Python."""

import subprocess
import sys
import unittest

import numpy as np
import opal
from recorded import DEMO, LOG, MAP, InFolder, scorers


class Errors(InFolder):
    def assert_says_what_the_program_says(self, error, call, *words):
        """The program prints the same sentence that `call` raises."""
        with self.assertRaises(error) as raised:
            call()
        self.assertIsInstance(raised.exception, opal.Error)
        self.assertIn(str(raised.exception), self.opal(*words, exit_code=3))

    def test_a_bad_map_is_told_in_the_words_of_the_program(self):
        bad = self.folder / "bad.jsonld"
        bad.write_text('{"@context": "urn:opal:v1", "@graph": [{"@id": "w", "@type": "Wall", "color": 3}]}')
        self.assert_says_what_the_program_says(opal.Error, lambda: opal.read_map(str(bad)), "map", "check", bad)

    def test_a_missing_map_is_told_in_the_words_of_the_program(self):
        self.assert_says_what_the_program_says(opal.Error, lambda: opal.read_map("none.jsonld"), "map", "check",
                                               "none.jsonld")

    def test_a_text_that_is_no_json_is_told_with_line_and_column(self):
        bad = self.folder / "bad.jsonld"
        bad.write_text("{")
        self.assert_says_what_the_program_says(opal.MapError, lambda: opal.read_map(str(bad)), "map", "check", bad)

    def test_a_missing_log_is_told_in_the_words_of_the_program(self):
        self.assert_says_what_the_program_says(opal.LogError, lambda: opal.read_log("none.log"), "localize", "malaga",
                                               "none.log", "--map", MAP)

    def test_a_deployment_that_does_not_exist_names_those_that_ship(self):
        with self.assertRaisesRegex(opal.ConfigError, "default.*malaga"):
            opal.read_deployment("nonesuch")

    def test_an_unknown_key_and_an_unknown_scorer_are_named_with_their_place(self):
        with self.assertRaisesRegex(opal.ConfigError, "hall.jsonld: /scorer"):
            opal.make_deployment({**scorers("opal:Beams"), "scorer": 1}, "hall.jsonld")
        deployment = opal.make_deployment(scorers("acme:None"), "hall.jsonld")
        with self.assertRaisesRegex(opal.ConfigError, r"hall\.jsonld: /scorers/0/@type: \"acme:None\".*opal:Beams"):
            opal.Localizer(deployment, opal.read_map(MAP))

    def test_a_localizer_without_a_map_says_so(self):
        with self.assertRaisesRegex(opal.ConfigError, "map"):
            opal.Localizer("default")

    def test_arrays_of_other_shapes_are_value_errors_that_name_argument_and_shape(self):
        laser = opal.Laser()
        with self.assertRaisesRegex(ValueError, r"odometry: an array of shape \(2,\), expected"):
            laser.sample([1.0], [0, 0], 1)
        with self.assertRaisesRegex(ValueError, r"ranges_m: an array of shape \(1, 2\), expected"):
            laser.sample([[1.0, 2.0]], [0, 0, 0], 1)
        with self.assertRaisesRegex(ValueError, "ranges_m: 180 numbers, expected 361, one for each beam"):
            laser.sample([1.0] * 180, [0, 0, 0], 1)
        with self.assertRaises((TypeError, ValueError)):
            laser.sample("abc", [0, 0, 0], 1)

    def test_a_laser_out_of_range_is_refused_like_one_in_a_document(self):
        with self.assertRaisesRegex(opal.ConfigError, "beams: 0, expected an integer from 1 to 100000"):
            opal.Laser(beams=0)
        with self.assertRaises(opal.ConfigError):
            opal.Laser(angle_increment_rad=float("nan"))

    def test_a_folder_without_plugins_and_a_bad_plugin_are_told(self):
        with self.assertRaisesRegex(opal.PluginError, "no such folder"):
            opal.add_plugins(str(self.folder / "none"))
        (self.folder / "bad.so").write_text("no library")
        with self.assertRaisesRegex(opal.ConfigError, "bad.so"):
            opal.add_plugins(str(self.folder))
        self.assertIn("opal:Beams", [plugin.name for plugin in opal.plugins()])

    def test_events_that_are_none_name_file_and_line(self):
        (self.folder / "events.jsonl").write_text('{"event": "run"}\nno event\n')
        events = opal.read_events(str(self.folder))
        self.assertEqual(next(events), {"event": "run"})
        with self.assertRaisesRegex(opal.EventError, r"events\.jsonl:2: column"):
            next(events)

    def test_nan_empty_and_huge_scans_are_a_status_and_no_error(self):
        localizer = opal.Localizer(opal.read_deployment("malaga"), opal.read_map(MAP))
        beams = localizer.deployment.lasers[0].beams
        odd = [np.full(beams, np.nan), np.full(beams, np.inf), np.full(beams, -1.0), np.zeros(beams), np.full(beams, 1e30),
               np.array([])]
        for k, ranges in enumerate(odd):
            estimate = localizer.update(ranges, [0.5 * k, 0, 0], 1.0 + k)
            self.assertNotEqual(estimate.status, "localized")
            self.assertTrue(np.all(np.isfinite(estimate.covariance)))
        for odometry, stamp_s in (([np.nan, np.inf, 0], 20.0), ([1e300, 0, 0], 21.0), ([3.5, 0, 0], np.nan)):
            self.assertIsNone(localizer.update(odd[0], odometry, stamp_s))
        self.assertIsNotNone(localizer.update(odd[0], [5.0, 0, 0], 22.0))

    def test_a_laser_that_is_not_there_is_named(self):
        localizer = opal.Localizer("malaga", opal.read_map(MAP))
        with self.assertRaisesRegex(ValueError, "laser: 1, expected one of 1"):
            localizer.update([1.0], [0, 0, 0], 1.0, laser=1)

    def test_results_that_cannot_be_written_are_a_write_error(self):
        run = opal.Localizer("malaga", opal.read_map(MAP)).run(
            opal.read_log(LOG).samples([opal.read_laser(f"{DEMO}.info.json")], to_s=-1))
        self.assertEqual((len(run), run.localized_after), (0, None))
        with self.assertRaisesRegex(opal.WriteError, "none/results.csv"):
            run.write_results(str(self.folder / "none" / "results.csv"))


LOOK_AT_THE_LOGGER = """
import ctypes.util
of_the_process = ctypes.CDLL(ctypes.util.find_library("spdlog"))._ZN6spdlog18default_logger_rawEv
of_the_process.restype = ctypes.c_void_p
usual = of_the_process()
import opal
assert of_the_process() == usual
"""


class Warnings(unittest.TestCase):
    def test_the_module_leaves_the_default_logger_of_the_process_alone(self):
        subprocess.run([sys.executable, "-c", LOOK_AT_THE_LOGGER], check=True)


if __name__ == "__main__":
    unittest.main()

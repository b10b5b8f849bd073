"""Simulated drives and generated buildings: the files of the program; storeys in answers."""

import json
import unittest

import numpy as np
import opal
from recorded import InFolder

WAY = {"drives": 2, "distance_m": 6, "people": 1, "clutter": 0.5}


class Simulations(InFolder):
    def made(self, name):
        return str(self.folder / name)

    def test_a_generated_building_is_that_of_the_program(self):
        self.opal("map", "generate", "office", "-o", "office.jsonld", "--seed", "3", "--size", "300")
        building = opal.generate_building("office", seed=3, size_m2=300)
        self.assertEqual(building.json_ld(), json.loads((self.folder / "office.jsonld").read_text()))
        with self.assertRaisesRegex(opal.ConfigError, "castle"):
            opal.generate_building("castle")

    def test_drives_leave_the_files_of_the_program(self):
        self.opal("map", "generate", "corridor", "-o", "corridor.jsonld", "--size", "300")
        self.opal("simulate", "corridor.jsonld", "-o", "program/drives", "--seed", "5", "--drives", "2", "--distance", "6",
                  "--people", "1", "--clutter", "0.5", "--along-walls", "0.7")
        building = opal.read_map(self.made("corridor.jsonld"))
        told = opal.simulate(building, self.made("python/drives"), seed=5, along_walls=0.7, **WAY)
        self.assertEqual(told["queries"], ["q01", "q02"])
        self.assertEqual(len(told["distances_m"]), 2)
        for ending in (".log.gz", ".gt.csv", ".info.json", ".queries.json", ".map.jsonld", ".map.pgm"):
            self.assertEqual((self.folder / f"python/drives{ending}").read_bytes(),
                             (self.folder / f"program/drives{ending}").read_bytes(), ending)

    def test_drives_can_be_run_as_a_bench_with_another_laser_in_a_damaged_building(self):
        building = opal.generate_building("office", seed=1, size_m2=300)
        laser = opal.Laser(beams=181, angle_min_rad=-np.pi / 2, angle_increment_rad=np.pi / 180, range_max_m=20)
        opal.simulate(building, self.made("drives"), lasers=[laser], damage="drop=0.1", **WAY)
        bench = opal.bench(self.made("drives"))
        self.assertEqual(len(bench.frame()), 2)
        self.assertEqual(len(opal.read_log(self.made("drives.log.gz")).raw_scans()[0].ranges_m), 181)

    def test_what_cannot_be_driven_is_told(self):
        building = opal.generate_building("office", size_m2=300)
        with self.assertRaisesRegex(opal.ConfigError, "lasers: none, expected one at least"):
            opal.simulate(building, self.made("drives"), lasers=[])
        with self.assertRaisesRegex(opal.ConfigError, "holes"):
            opal.simulate(building, self.made("drives"), damage="holes=3")
        for share in (-0.1, 0.96, float("nan")):
            with self.assertRaisesRegex(opal.ConfigError, "along_walls: .*, expected a number from 0 to 0.95"):
                opal.simulate(building, self.made("drives"), along_walls=share)
        for name, value in (("drives", 0), ("distance_m", -5.0), ("people", -1), ("doors_open", 70.0), ("clutter", -1.0)):
            with self.assertRaisesRegex(opal.ConfigError, f"simulate: {name}: {value:g}, expected a number from "):
                opal.simulate(building, self.made("nothing"), **{name: value})
        self.assertEqual(list(self.folder.glob("nothing*")), [])

    def test_results_on_storeys_name_them_as_results_csv_does(self):
        for name, seed in (("ground", 1), ("upper", 2)):
            self.opal("map", "generate", "office", "-o", f"{name}.jsonld", "--seed", str(seed), "--size", "300")
        self.opal("map", "stack", "ground.jsonld", "upper.jsonld", "-o", "both.jsonld")
        both = opal.read_map(self.made("both.jsonld"))
        opal.simulate(both, self.made("drives"), **WAY)
        localizer = opal.Localizer("default", both)
        lasers = [opal.read_laser(self.made("drives.info.json"))]
        run = localizer.run(opal.read_log(self.made("drives.log.gz")).samples(lasers))
        run.write_results(self.made("results.csv"))
        head, *rows = (self.folder / "results.csv").read_text().splitlines()
        self.assertEqual(list(run.columns()), head.split(","))
        self.assertEqual(run.columns()["storey"], [row.split(",")[-1] for row in rows])
        self.assertEqual(list(run.frame().columns), head.split(","))
        place = run.last.place
        self.assertEqual(place.storey, run.columns()["storey"][-1])
        self.assertEqual(place.pose.shape, (3,))
        self.assertIn(place.storey, repr(place))

    def test_a_map_of_one_storey_names_none(self):
        building = opal.generate_building("corridor", size_m2=300)
        opal.simulate(building, self.made("drives"), **WAY)
        run = opal.bench(self.made("drives")).run
        self.assertNotIn("storey", run.columns())
        self.assertIsNone(run.last.place)


if __name__ == "__main__":
    unittest.main()

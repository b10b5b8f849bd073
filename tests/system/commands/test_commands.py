"""What the commands print first, and that options, names and documents reach them. OPAL_PROGRAM is the program."""

import json
import os
import pathlib
import re
import subprocess

from program_in_folder import DEMO, LOG, MAP, ROOT, InFolder


class Commands(InFolder):
    def deployment(self, **members):
        document = {"@context": "urn:opal:v1", "@type": "opal:Deployment", "scorers": [{"@type": "opal:Beams"}], **members}
        file = self.folder / "deployment.jsonld"
        file.write_text(json.dumps(document))
        return file

    def localize(self, *words, config="malaga", exit_code=0):
        return self.opal("localize", config, LOG, "--map", MAP, "-o", "out", *words, exit_code=exit_code)


class DidItWork(Commands):
    def test_localize_says_first_when_and_after_how_many_metres_it_was_localized(self):
        self.assertRegex(self.localize().splitlines()[0], r"^localized after \d+\.\d m and \d+\.\d s$")

    def test_a_plugin_that_fails_is_told_on_stderr_and_results_stand_alone(self):
        scorers = [{"@type": "opal:Beams"}, {"@type": "faulty:Scorer", "options": {"how": "throw"}}]
        file = self.deployment(scorers=scorers, **{"@context": ["urn:opal:v1", {"faulty": "https://faulty.example/#"}]})
        done = subprocess.run([os.environ["OPAL_PROGRAM"], "localize", file, LOG, "--map", MAP, "--info", f"{DEMO}.info.json"],
                              cwd=self.folder, text=True, capture_output=True,
                              env={**os.environ, "OPAL_PLUGIN_PATH": os.environ["OPAL_FAULTY_PLUGINS"]})
        self.assertIn("faulty:Scorer: skipped: not today\n", done.stderr)
        self.assertRegex(done.stdout.splitlines()[0], r"^(localized after|never localized in) ")

    def test_localize_has_one_line_for_every_query(self):
        lines = self.localize("--queries", f"{DEMO}.queries.json", "--truth", f"{DEMO}.gt.csv").splitlines()
        queries = [query["id"] for query in json.loads(pathlib.Path(f"{DEMO}.queries.json").read_text())["queries"]]
        self.assertRegex(lines[0], rf"^\d of {len(queries)} queries localized, after \d+\.\d m \(median\)$")
        for line, query in zip(lines[1:], queries):
            self.assertRegex(line, rf"^{query}: (localized after|never localized in) .* at the end .* off the truth$")

    def test_bench_says_first_whether_it_worked_then_what_was_false_then_the_costs(self):
        lines = self.opal("bench", DEMO, "-o", "out").splitlines()
        self.assertRegex(lines[0], r"^success in 5 of 5 queries \(strict: 5\), after \d+\.\d m \(median\)$")
        self.assertRegex(lines[1], r"^localized in \d of 5 queries")
        self.assertRegex(lines[2], r"^wrongly localized: 0 of \d+ localized rows, in 0 queries$")
        self.assertRegex(lines[3], r"^CPU per update ")
        verdict = json.loads((self.folder / "out" / "summary.json").read_text())["verdict"]
        self.assertEqual((verdict["success"], verdict["false_rows"], verdict["failed"]), (5, 0, []))

    def test_map_check_finds_nothing_to_warn_about_in_maps_of_our_own(self):
        self.opal("map", "import", MAP, "-o", "demo.jsonld")
        for file in ["demo.jsonld", *sorted((ROOT / "maps").glob("*.jsonld"))]:
            self.assertNotIn("warning", self.opal("map", "check", file), file)

    def test_explain_says_what_a_found_place_waits_for(self):
        self.localize()
        words = dict(json.loads(self.opal("explain", "out", "--at", "0", "--json"))["words"][::-1])
        self.assertIn("searching (a place is found, but not proven yet)", words["answer"])
        self.assertIn("not localized yet, it waits for more evidence: ", self.opal("explain", "out", "--at", "0"))


class SeveralStoreys(Commands):
    def plan(self, name, wide_deg):
        """A room with a lift, drawn in degrees, and as far to the east as asked for."""
        def thing(kind, coordinates, **properties):
            return {"type": "Feature", "geometry": {"type": kind, "coordinates": coordinates}, "properties": properties}
        west, south, east, north = 5.48, 51.44, 5.48 + wide_deg, 51.4402
        ring = [[west, south], [east, south], [east, north], [west, north], [west, south]]
        things = [thing("LineString", ring, indoor="wall"), thing("Point", [5.4801, 51.4401], highway="elevator")]
        (self.folder / name).write_text(json.dumps({"type": "FeatureCollection", "features": things}))

    def stacked(self, *words):
        self.plan("ground.geojson", 0.0004)
        self.plan("upper.geojson", 0.0009)
        return self.opal("map", "stack", "ground.geojson", "upper.geojson", "-o", "both.jsonld", *words)

    def test_plans_in_degrees_that_are_stacked_have_one_origin(self):
        self.assertRegex(self.stacked(), r"lift-1: at x -\d+\.\d, y 0\.0, 2 storeys")
        self.assertIn("2 storeys, 1 connection, ", self.stacked())

    def test_options_of_importers_reach_the_plans_of_a_stack(self):
        self.assertIn("lift-1: at x 0.0, y 0.0, 2 storeys",
                      self.stacked("--set", "origin_lon_deg=5.4801", "--set", "origin_lat_deg=51.4401"))

    def test_drive_refuses_an_unknown_storey_before_it_does_anything(self):
        self.stacked()
        said = self.opal("drive", "default", "both.jsonld", "--storey", "cellar", exit_code=3)
        self.assertIn("no storey 'cellar', expected one of 'ground', 'upper'", said)


class OptionsReachEverything(Commands):
    def test_the_version_is_told(self):
        self.assertRegex(self.opal("--version"), r"^opal \d+\.\d+\.\d+$")

    def test_shipped_configurations_are_found_by_name_and_an_unknown_name_gets_the_list(self):
        self.assertIn("localized", self.localize(config="malaga"))
        self.assertIn("ship: careful, careful_two_lasers, default, malaga", self.localize(config="nowhere", exit_code=3))

    def test_a_file_that_nobody_recognizes_gets_the_list_of_what_is_read(self):
        (self.folder / "odd.txt").write_text("odd")
        maps = self.opal("map", "import", "odd.txt", "-o", "map.jsonld", exit_code=3)
        self.assertIn("opal:GridImporter", maps)
        self.assertIn("opal:IfcImporter", maps)
        logs = self.opal("localize", "malaga", "odd.txt", "--map", MAP, exit_code=3)
        self.assertIn("opal:CarmenLog", logs)
        self.assertIn("opal:Ros2Bag", logs)

    def test_log_sources_take_options_from_the_command_line_and_from_the_deployment(self):
        self.assertIn("localized", self.localize("--log-set", "laser_message=FLASER"))
        self.assertIn("laser_message", self.localize("--log-set", "topic=/scan", exit_code=3))
        sensor = json.loads((ROOT / "configs" / "malaga.jsonld").read_text())["sensor"]
        for message, exit_code in (("FLASER", 0), ("RAWLASER1", 3)):
            sources = [{"@type": "opal:CarmenLog", "options": {"laser_message": message}}]
            config = self.deployment(log_sources=sources, sensor=sensor)
            self.localize(config=config, exit_code=exit_code)

    def test_options_for_another_log_source_are_told_not_to_be_used(self):
        sensor = json.loads((ROOT / "configs" / "malaga.jsonld").read_text())["sensor"]
        sources = [{"@type": "opal:McapLog", "options": {"scan_topic": "/front"}}]
        said = self.localize(config=self.deployment(log_sources=sources, sensor=sensor))
        self.assertIn("/log_sources: has options for opal:McapLog, and none for opal:CarmenLog: they are not used", said)

    def test_every_command_that_plays_a_log_takes_options_of_its_source(self):
        log = ROOT / "maps/malaga/malaga-demo.log.gz"
        self.assertIn("laser_message", self.opal("calibrate", "malaga", log, "--log-set", "topic=/scan", exit_code=3))
        learn = ("learn", MAP, log, "--config", "malaga", "-o", "overlay.jsonld", "--log-set", "topic=/scan")
        self.assertIn("laser_message", self.opal(*learn, exit_code=3))

    def test_deployments_define_prefixes(self):
        context = ["urn:opal:v1", {"acme": "https://acme.example/opal#"}]
        self.assertIn("localized", self.localize(config=self.deployment(**{"@context": context})))
        for wrong in ([{"acme": "https://acme.example/"}], ["urn:opal:v1", {"opal": "https://acme.example/"}]):
            config = self.deployment(**{"@context": wrong})
            self.assertIn("/@context", self.localize(config=config, exit_code=3))

    def test_simulate_takes_the_laser_of_a_deployment(self):
        room = ROOT / "maps" / "example_room.jsonld"
        self.opal("simulate", room, "-o", "drive", "--config", "malaga", "--drives", "1", "--distance", "2")
        laser = json.loads((self.folder / "drive.info.json").read_text())["laser"]
        self.assertEqual((laser["n_beams"], laser["offset_x_m"]), (361, 0.78))
        self.assertIn("/sensor", self.opal("simulate", room, "-o", "drive", "--config", "default", exit_code=3))

    def test_drive_goes_on_with_seeds_that_can_reach_the_goal_and_ends_with_round_numbers(self):
        self.opal("map", "generate", "office", "-o", "office.jsonld", "--seed", "1", "--size", "300")
        drive = ["drive", "default", "office.jsonld", "--goal", "3,3", "--doors-open", "0.5", "--most", "2", "-o", "out"]
        self.assertIn("is shut (--doors-open 1 opens all)", self.opal(*drive, exit_code=3))
        said = self.opal(*drive, "--runs", "4", exit_code=1)
        self.assertEqual(json.loads((self.folder / "out" / "summary.json").read_text())["drives"], 1)
        self.assertRegex(said, r"seed 4: GIVEN UP")
        for number in (value for value in json.loads(said.splitlines()[-1]).values() if isinstance(value, float)):
            self.assertEqual(number, round(number, 3))

    def test_a_careful_deployment_is_localized_later(self):
        usual = self.localize()
        (self.folder / "careful.jsonld").write_text(json.dumps({**json.loads((ROOT / "configs" / "malaga.jsonld").read_text()),
                                                                "map": str(MAP), "caution": "careful"}))
        careful = self.localize(config="careful.jsonld")
        metres = [float(re.match(r"localized after (\d+\.\d) m", text)[1]) for text in (usual, careful)]
        self.assertLess(metres[0], metres[1])

    def test_a_drive_of_a_campaign_is_repeated_by_its_number(self):
        words = ("experiment", "integrity", "--drives", "20", "--duration", "10", "-o", "out", "--repeat")
        self.assertIn("expected a drive of the campaign, 0 to 19", self.opal(*words, "20", exit_code=3))
        self.opal(*words, "3")
        self.assertEqual(json.loads((self.folder / "out" / "drive.json").read_text())["drive"], 3)

    def test_drive_takes_the_laser_of_a_deployment(self):
        room = ROOT / "maps" / "example_room.jsonld"
        self.opal("drive", "malaga", room, "--goal", "1,4", "--most", "1", "--record", "drive", exit_code=1)
        laser = json.loads((self.folder / "drive.info.json").read_text())["laser"]
        self.assertEqual((laser["n_beams"], laser["offset_x_m"]), (361, 0.78))

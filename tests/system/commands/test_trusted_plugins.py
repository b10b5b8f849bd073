"""A deployment that says which plugins it trusts: the list that the program prints, and what does not run."""

import json

from program_in_folder import LOG, MAP, ROOT, InFolder


class TrustedPlugins(InFolder):
    def deployment(self, trusted=None, **members):
        document = json.loads((ROOT / "configs" / "malaga.jsonld").read_text())
        document.update(members)
        if trusted is not None:
            document["trusted_plugins"] = trusted
        (self.folder / "hall.jsonld").write_text(json.dumps(document))
        return "hall.jsonld"

    def printed(self, *words, config="hall.jsonld"):
        said = self.opal("plugins", "--digests", config, *words)
        return json.loads("{" + said + "}")["trusted_plugins"]

    def localize(self, *words, exit_code=0):
        return self.opal("localize", "hall.jsonld", LOG, "--map", MAP, "-o", "out", *words, exit_code=exit_code)

    def test_the_printed_list_is_all_that_a_run_needs(self):
        self.deployment()
        trusted = self.printed("--map", MAP, "--log", LOG)
        names = [entry["plugin"] for entry in trusted]
        self.assertEqual(names, sorted(names))
        self.assertTrue({"carmen_log", "grid_importer", "lines", "score_beams"} <= set(names), names)
        self.assertNotIn("ros2_bag", names)
        self.deployment(trusted)
        self.assertIn("localized", self.localize())
        self.assertEqual(self.printed("--map", MAP, "--log", LOG), trusted)

    def test_every_one_of_them_is_needed(self):
        self.deployment()
        trusted = self.printed("--map", MAP, "--log", LOG)
        for entry in trusted:
            self.deployment([other for other in trusted if other != entry])
            said = self.localize(exit_code=3)
            self.assertIn(entry["plugin"], said)
            self.deployment([{**other, "sha256": "0" * 64} if other == entry else other for other in trusted])
            said = self.localize(exit_code=3)
            self.assertIn(f"/sha256: plugin {entry['plugin']}: ", said)
            self.assertIn(f"has SHA-256 {entry['sha256']}, expected {'0' * 64}", said)

    def test_descriptions_are_needed_as_they_are(self):
        self.deployment()
        trusted = self.printed("--map", MAP, "--log", LOG)
        entry = trusted[0]
        self.deployment([{**entry, "description_sha256": "0" * 64}, *trusted[1:]])
        said = self.localize(exit_code=3)
        self.assertIn(f"/description_sha256: plugin {entry['plugin']}: ", said)
        self.assertIn(f"has SHA-256 {entry['description_sha256']}, expected {'0' * 64}", said)

    def test_readers_that_are_not_listed_are_not_asked(self):
        self.deployment()
        trusted = [entry for entry in self.printed("--map", MAP, "--log", LOG) if entry["plugin"] != "carmen_log"]
        self.deployment(trusted)
        self.assertIn("(not asked: trusted_plugins does not name carmen_log)", self.localize(exit_code=3))

    def test_a_map_of_the_command_line_is_imported_by_trusted_plugins_only(self):
        self.deployment([])
        for words in (["localize", "hall.jsonld", LOG, "--map", MAP], ["map", "import", MAP, "-o", "m.jsonld", "--config", "hall.jsonld"]):
            self.assertIn("(not asked: trusted_plugins does not name grid_importer)", self.opal(*words, exit_code=3))

    def test_an_experiment_is_refused_before_its_cells(self):
        self.deployment([])
        arm = {"deployment": "hall.jsonld", "overrides": {"map": None, "sensor": None}}
        experiment = {"@context": "urn:opal:v1", "@type": "opal:Experiment",
                      "arms": [{"name": "a", **arm}, {"name": "b", **arm}],
                      "sites": [{"prefix": LOG[: -len(".log.gz")]}]}
        (self.folder / "ab.jsonld").write_text(json.dumps(experiment))
        said = self.opal("ab", "ab.jsonld", "-o", "ab", exit_code=3)
        self.assertIn("/trusted_plugins: plugin ", said)
        self.assertIn("is not in the list", said)

    def test_a_list_needs_a_map(self):
        self.assertIn("/map: absent, expected a map here or by --map", self.opal("plugins", "--digests", "default", exit_code=3))

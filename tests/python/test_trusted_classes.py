"""Files of classes that a deployment trusts: what was changed, is not listed, or is cached by Python does not run."""

import hashlib
import importlib.util
import json
import os
import py_compile
import unittest

import opal
from recorded import DEMO, MAP, InFolder, scorers

SCORER = '''
import pathlib

import numpy as np

pathlib.Path(__file__).with_name("ran-{name}").touch()


class Scorer:
    def score(self, hypotheses, observation, map):
        return np.zeros(len(hypotheses))
'''


class TrustedClasses(InFolder):
    def setUp(self):
        super().setUp()
        self.file = self.folder / "mine.py"
        self.file.write_text(SCORER.format(name="mine"))
        self.deployment()
        self.trusted = json.loads("{" + self.opal("plugins", "--digests", "d.jsonld", "--map", MAP) + "}")["trusted_plugins"]
        self.forget()

    def deployment(self, trusted=None, scorer="mine.py:Scorer", **members):
        document = scorers("opal:Beams", scorer, **members)
        document["scorers"][1]["role"] = "observes"
        if trusted is not None:
            document["trusted_plugins"] = trusted
        (self.folder / "d.jsonld").write_text(json.dumps(document))
        return opal.read_deployment(str(self.folder / "d.jsonld"))

    def forget(self):
        for trace in self.folder.glob("ran-*"):
            trace.unlink()

    def ran(self):
        return sorted(trace.name for trace in self.folder.glob("ran-*"))

    def bench(self, exit_code=0):
        return self.opal("bench", DEMO, "--config", "d.jsonld", "-o", "out", exit_code=exit_code)

    def refused(self, *words):
        """The class runs neither in the program nor in the module."""
        self.forget()
        said = self.bench(exit_code=3)
        with self.assertRaises(opal.ConfigError) as raised:
            opal.Localizer(opal.read_deployment(str(self.folder / "d.jsonld")), opal.read_map(MAP))
        self.assertEqual(self.ran(), [])
        for word in words:
            self.assertIn(word, said)
            self.assertIn(word, str(raised.exception))

    def with_log_source(self):
        """The list for a bench, which reads a log, too."""
        log = json.loads("{" + self.opal("plugins", "--digests", "d.jsonld", "--map", MAP, "--log", DEMO + ".log.gz") + "}")
        return log["trusted_plugins"]

    def test_the_printed_list_has_the_file_and_what_runs_it(self):
        digest = hashlib.sha256(self.file.read_bytes()).hexdigest()
        self.assertIn({"file": "mine.py", "sha256": digest}, self.trusted)
        self.assertIn("python", [entry.get("plugin") for entry in self.trusted])
        self.deployment(self.with_log_source())
        self.forget()
        self.bench()
        self.assertEqual(self.ran(), ["ran-mine"])

    def test_a_file_that_was_changed_does_not_run(self):
        self.deployment(self.with_log_source())
        old = hashlib.sha256(self.file.read_bytes()).hexdigest()
        self.file.write_text(SCORER.format(name="other"))
        new = hashlib.sha256(self.file.read_bytes()).hexdigest()
        self.refused("/sha256: class Scorer: ", "mine.py has SHA-256 " + new, "expected " + old)

    def test_a_file_that_is_not_listed_does_not_run(self):
        self.deployment([entry for entry in self.with_log_source() if "file" not in entry])
        self.refused("/trusted_plugins: class Scorer: ", "is not in the list, expected one of: none")

    def test_a_file_does_not_run_if_the_plugin_that_runs_it_is_not_listed(self):
        self.deployment([entry for entry in self.with_log_source() if entry.get("plugin") != "python"])
        self.refused("/trusted_plugins: plugin python: ", "is not in the list")

    def test_the_plugin_of_classes_that_is_named_as_a_type_is_covered_too(self):
        trusted = self.with_log_source()
        for source, words in ((f"{self.folder}/mine.py:Scorer", "has SHA-256"),
                              ("opal.examples:Likelihood", "is a class of a module, expected FILE.py:CLASS")):
            document = scorers("opal:Beams", "opal:PythonScorer", trusted_plugins=trusted)
            document["scorers"][1].update({"role": "observes", "options": {"class": source, "options": "{}"}})
            (self.folder / "d.jsonld").write_text(json.dumps(document))
            self.file.write_text(SCORER.format(name="other"))
            self.refused(words)

    def test_what_python_has_cached_beside_a_file_does_not_run(self):
        self.deployment(self.with_log_source())
        status = self.file.stat()
        source = self.file.read_bytes()
        self.file.write_bytes(SCORER.format(name="evil").encode())
        os.utime(self.file, ns=(status.st_atime_ns, status.st_mtime_ns))
        cached = importlib.util.cache_from_source(str(self.file))
        py_compile.compile(str(self.file), cached, doraise=True,
                           invalidation_mode=py_compile.PycInvalidationMode.UNCHECKED_HASH)
        self.file.write_bytes(source)
        os.utime(self.file, ns=(status.st_atime_ns, status.st_mtime_ns))
        self.forget()
        self.bench()
        self.assertEqual(self.ran(), ["ran-mine"])

    def test_a_bench_of_the_module_reads_maps_and_logs_by_trusted_plugins_only(self):
        deployment = self.deployment(self.with_log_source())
        self.assertIn("5 of 5", str(opal.bench(DEMO, deployment).summary))
        for name in ("grid_importer", "carmen_log"):
            trusted = [entry for entry in self.with_log_source() if entry.get("plugin") != name]
            with self.assertRaisesRegex(opal.Error, f"not asked: trusted_plugins does not name {name}"):
                opal.bench(DEMO, self.deployment(trusted))


if __name__ == "__main__":
    unittest.main()

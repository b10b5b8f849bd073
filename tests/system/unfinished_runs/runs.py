"""Starts the program, waits until it is in the middle of its work, and looks at what it leaves."""

import csv
import json
import os
import pathlib
import subprocess
import tempfile
import time
import unittest

TREE = pathlib.Path(__file__).resolve().parents[3]
MALAGA = str(TREE / "maps" / "malaga" / "malaga")
CORRIDOR = str(TREE / "maps" / "malaga" / "malaga-demo")
CONFIG = str(TREE / "configs" / "malaga.jsonld")
PATIENCE_S = 120


def program():
    return os.environ["OPAL_PROGRAM"]


class RunTest(unittest.TestCase):
    """A test with a folder of its own."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def start(self, *words):
        process = subprocess.Popen([program(), *map(str, words)], cwd=self.folder, stdin=subprocess.DEVNULL,
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.addCleanup(self.end, process)
        return process

    @staticmethod
    def end(process):
        if process.poll() is None:
            process.kill()
        process.communicate()

    def run_to_its_end(self, *words, expected=0):
        done = subprocess.run([program(), *map(str, words)], cwd=self.folder, stdin=subprocess.DEVNULL,
                              capture_output=True, text=True, timeout=PATIENCE_S)
        self.assertEqual(done.returncode, expected, done.stdout + done.stderr)
        return done

    def wait_until(self, what, is_so, process=None):
        end = time.monotonic() + PATIENCE_S
        while not is_so():
            self.assertLess(time.monotonic(), end, "waited in vain until " + what)
            if process is not None and process.poll() is not None:
                self.fail(f"ended before {what}: " + "".join(process.communicate()))
            time.sleep(0.01)

    def interrupt(self, process, signal_number):
        process.send_signal(signal_number)
        out, errors = process.communicate(timeout=PATIENCE_S)
        return process.returncode, out, errors

    def many_queries(self, count):
        """The same window of the corridor again and again: a run that takes a while."""
        file = self.folder / "many.queries.json"
        queries = [{"id": f"q{k}", "start_time": 0, "end_time": 9.3} for k in range(count)]
        file.write_text(json.dumps({"queries": queries}))
        return file

    def long_localize(self, out="out"):
        """Localizes for minutes unless somebody stops it."""
        return ["localize", CONFIG, CORRIDOR + ".log.gz", "--map", CORRIDOR + ".map.yaml", "--queries",
                self.many_queries(2000), "-o", out]

    def starts_of(self, out="out"):
        """Queries that have begun, by the events that are on the disk."""
        try:
            return (self.folder / out / "events.jsonl").read_text().count('{"event":"start"')
        except FileNotFoundError:  # not yet there, or a new run has just put away that of an earlier one
            return 0

    def events(self, out="out"):
        """All events; a line that is none fails the test."""
        text = (self.folder / out / "events.jsonl").read_text()
        self.assertTrue(text.endswith("\n"))
        return [json.loads(line) for line in text.splitlines()]

    @staticmethod
    def computed_s(process):
        """CPU time that it has used so far."""
        fields = pathlib.Path(f"/proc/{process.pid}/stat").read_text().rsplit(")", 1)[1].split()
        return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")

    def rows(self, out="out"):
        return list(csv.DictReader((self.folder / out / "results.csv").read_text().splitlines()))

    def marker(self, out="out"):
        file = self.folder / out / "unfinished.json"
        text = file.read_text() if file.exists() else ""
        return json.loads(text) if text else None  # it is empty while it is being written

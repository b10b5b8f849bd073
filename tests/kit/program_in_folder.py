"""The program as people type it, in a folder that goes away, on the recorded hall that ships with it. OPAL_PROGRAM is the program."""

import os
import pathlib
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
DEMO = str(ROOT / "maps" / "malaga" / "malaga-demo")
MAP = f"{DEMO}.map.yaml"
LOG = f"{DEMO}.log.gz"


class InFolder(unittest.TestCase):
    """A test with a temporary folder, and the program."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def opal(self, *words, exit_code=0):
        """@return what was printed, errors included. Runs in the folder."""
        done = subprocess.run([os.environ["OPAL_PROGRAM"], *map(str, words)], cwd=self.folder, text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        self.assertEqual(done.returncode, exit_code, done.stdout)
        return done.stdout

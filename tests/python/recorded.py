"""What the tests run on: the recorded hall that ships with Opal."""

import os
import pathlib
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
DEMO = str(ROOT / "maps" / "malaga" / "malaga-demo")
MAP = f"{DEMO}.map.yaml"
LOG = f"{DEMO}.log.gz"


def scorers(*types, **members):
    """A deployment document with these scorers."""
    return {"@context": "urn:opal:v1", "@type": "opal:Deployment", "scorers": [{"@type": name} for name in types],
            **members}


class InFolder(unittest.TestCase):
    """A test with a temporary folder, and the program."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def program(self, *words, exit_code=0):
        """What the program prints, errors included."""
        done = subprocess.run([os.environ["OPAL_PROGRAM"], *map(str, words)], cwd=self.folder, text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        self.assertEqual(done.returncode, exit_code, done.stdout)
        return done.stdout

"""Types: stubs and module agree (stubtest), and mypy understands a program that uses them."""

import importlib.util
import inspect
import os
import pathlib
import subprocess
import sys
import unittest

import opal
from recorded import InFolder

PACKAGE = pathlib.Path(opal.__file__).parent

USES = '''
import numpy as np
import opal
from opal import drawing

localizer = opal.Localizer("malaga", opal.read_map("map.jsonld"), events=lambda event: None)
estimate = localizer.update(np.zeros(361), [0.0, 0.0, 0.0], 1.0)
if estimate is not None and estimate.pose is not None:
    x: float = float(estimate.pose[0])
for sample in opal.read_log("log.gz").samples(localizer.deployment, from_s=3):
    localizer.update(sample)
drawing.draw_map(localizer.map)
opal.simulate(opal.generate_building("office", seed=2), "out/drives", drives=2)
first: str = opal.read_ab("out/two").sentences[0]
'''

MISUSES = ['opal.read_map(3)', 'opal.Localizer("malaga").update("scan")', 'opal.bench("place").run.cpu',
           'opal.Laser(361)', 'opal.Localizer("malaga").update([1.0], [0, 0, 0], "now")',
           'opal.read_log("a").samples(3)', 'opal.simulate("map", "out")']


@unittest.skipUnless(importlib.util.find_spec("mypy"), "mypy is not installed")
class Types(InFolder):
    def mypy(self, module, *words):
        environment = {**os.environ, "MYPYPATH": str(PACKAGE.parent), "MYPY_CACHE_DIR": str(self.folder / "cache")}
        return subprocess.run([sys.executable, "-m", module, *words], cwd=self.folder, text=True, env=environment,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT)

    def test_the_stubs_are_those_of_the_module(self):
        allowed = self.folder / "allowed.txt"  # classes of pybind11 have a metaclass, and an __init__ that takes anything
        allowed.write_text("opal\\._opal\\.[A-Z]\\w+\nopal\\._opal\\.[A-Z]\\w+\\.__init__\n")
        done = self.mypy("mypy.stubtest", "opal._opal", "--ignore-missing-stub", "--ignore-positional-only",
                         "--allowlist", str(allowed), "--ignore-unused-allowlist")
        self.assertEqual(done.returncode, 0, done.stdout)

    def test_the_package_itself_is_typed(self):
        done = self.mypy("mypy", "--strict", "--ignore-missing-imports", str(PACKAGE))
        self.assertEqual(done.returncode, 0, done.stdout)

    def test_a_program_is_understood(self):
        (self.folder / "uses.py").write_text(USES)
        done = self.mypy("mypy", "--ignore-missing-imports", "uses.py")
        self.assertEqual(done.returncode, 0, done.stdout)

    def test_a_wrong_program_is_refused_line_by_line(self):
        (self.folder / "misuses.py").write_text("import opal\n" + "\n".join(MISUSES) + "\n")
        done = self.mypy("mypy", "--ignore-missing-imports", "misuses.py")
        for number in range(len(MISUSES)):
            self.assertIn(f"misuses.py:{number + 2}: error", done.stdout)


class Docstrings(unittest.TestCase):
    def test_every_class_and_function_says_what_it_is_for(self):
        for name in opal.__all__:
            self.assertTrue(inspect.getdoc(getattr(opal, name)), name)

    def test_arrays_say_their_shape(self):
        silent = []
        for owner in ("Map", "Scan", "Sample", "Estimate", "Hypothesis", "Run", "Log", "RawScan", "View", "Place"):
            for name, member in vars(getattr(opal, owner)).items():
                text = inspect.getdoc(member) or ""
                is_array = any(word in text for word in ("[m]", "[rad]", "array"))
                if is_array and "shape (" not in text and "columns" not in name:
                    silent.append(f"{owner}.{name}: {text}")
        self.assertEqual(silent, [])


if __name__ == "__main__":
    unittest.main()

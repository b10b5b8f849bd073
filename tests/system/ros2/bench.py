"""Programs beside each other for the tests of `opal ros2`: a robot by Fast DDS, the node, and who listens. Loopback only, a domain for each test."""

import json
import os
import pathlib
import shutil
import signal
import subprocess
import tempfile
import time
import unittest

TREE = pathlib.Path(__file__).resolve().parents[3]
MALAGA = TREE / "maps/malaga"
PROGRAM = os.environ["OPAL_PROGRAM"]
ROBOT = os.environ["OPAL_FASTDDS_ROBOT"]
EPOCH_S = 1_700_000_000  # what the robot adds to the stamps of a log
SCANS = 37  # of the demo's recording
PATIENCE_S = 60 * int(os.environ.get("OPAL_SLOWER", "1"))  # times as slow: under a sanitizer
# What the log calls it, frame, topic, kind, first angle, increment, range_max, sweep; mount: x, y, heading.
PLANAR = "FLASER,laser,/scan,scan,-1.5707963268,0.0087266462600,81,0,0.78,0,0"
LIDAR = PLANAR.replace("/scan,scan", "/points,cloud").replace(",laser,", ",lidar,")


class Bench(unittest.TestCase):
    """Programs in a folder of their own and on a domain of their own."""
    domains = 0

    def setUp(self):
        Bench.domains += 1
        self.domain = str(1 + (7 * os.getpid() + 23 * Bench.domains) % 230)
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="opal_ros2_"))
        self.addCleanup(shutil.rmtree, self.folder)

    def start(self, *words, **more):
        variables = {k: v for k, v in os.environ.items() if not k.startswith(("ROS_", "CYCLONE"))}
        variables.update(more, ROS_DOMAIN_ID=self.domain)
        process = subprocess.Popen([PROGRAM, *map(str, words)], cwd=self.folder, env=variables, text=True,
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        self.addCleanup(process.stdout.close)
        self.addCleanup(process.stderr.close)
        self.addCleanup(process.kill)
        return process

    def play(self, speed, motion, quality, lasers=(PLANAR,), log=MALAGA / "malaga-demo.log.gz", said=None):
        """What the robot heard while it played the recording, a line a message. @param said  lines for the recording, by the number of the line before"""
        records = subprocess.run(["gzip", "-dc", log], stdout=subprocess.PIPE, check=True).stdout
        records = b"".join(line + "".join(f"{words}\n" for words in (said or {}).get(k, ())).encode()
                           for k, line in enumerate(records.splitlines(keepends=True)))
        done = subprocess.run([ROBOT, self.domain, str(speed), motion, quality, *lasers], input=records,
                              stdout=subprocess.PIPE, timeout=PATIENCE_S, check=True)
        return done.stdout.decode().splitlines()

    def stop(self, process):
        """Asks to stop. @return (exit code, stderr, seconds that it took)"""
        begin = time.monotonic()
        process.send_signal(signal.SIGTERM)
        errors = process.communicate(timeout=PATIENCE_S)[1]
        return process.returncode, errors, time.monotonic() - begin

    def drive(self, speed, motion, quality, *words, config="malaga", map=MALAGA / "malaga-demo.map.yaml", **played):
        node = self.start("ros2", config, "--map", map, *words)
        heard = self.play(speed, motion, quality, **played)
        code, errors, seconds = self.stop(node)
        self.assertEqual(code, 0, errors)
        self.assertLess(seconds, 1.5, errors)
        return heard, errors


def numbers(heard, kind):
    """The words of all lines of a kind behind its name."""
    return [line.split()[1:] for line in heard if line.startswith(kind + " ")]


def replayed(folder):
    """Stamp, x and y of every pose that `opal localize` has written."""
    lines = (folder / "trajectory.tum").read_text().splitlines()
    return [list(map(float, line.split()[:3])) for line in lines if not line.startswith("#")]


def read_config(name):
    return json.loads((TREE / f"configs/{name}.jsonld").read_text())

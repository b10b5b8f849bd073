"""A robot that speaks by Fast DDS, with its own types and its own CDR, beside `opal ros2`. Loopback only, a domain for each test."""

import json
import math
import os
import pathlib
import shutil
import signal
import socket
import subprocess
import tempfile
import time
import unittest

TREE = pathlib.Path(__file__).resolve().parents[3]
MALAGA = TREE / "maps/malaga"
PROGRAM = os.environ["OPAL_PROGRAM"]
ROBOT = os.environ["OPAL_FASTDDS_ROBOT"]
SCANS = 37  # of the demo's recording
PATIENCE_S = 60


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

    def play(self, speed, motion, quality):
        """What the robot heard while it played the recording, a line a message."""
        log = subprocess.run(["gzip", "-dc", MALAGA / "malaga-demo.log.gz"], stdout=subprocess.PIPE, check=True).stdout
        done = subprocess.run([ROBOT, self.domain, str(speed), motion, quality], input=log, stdout=subprocess.PIPE,
                              timeout=PATIENCE_S, check=True)
        return done.stdout.decode().splitlines()

    def stop(self, process):
        """Asks to stop. @return (exit code, stderr, seconds that it took)"""
        begin = time.monotonic()
        process.send_signal(signal.SIGTERM)
        errors = process.communicate(timeout=PATIENCE_S)[1]
        return process.returncode, errors, time.monotonic() - begin

    def drive(self, speed, motion, quality, *words):
        node = self.start("ros2", "malaga", "--map", MALAGA / "malaga-demo.map.yaml", *words)
        heard = self.play(speed, motion, quality)
        code, errors, seconds = self.stop(node)
        self.assertEqual(code, 0, errors)
        self.assertLess(seconds, 1.5, errors)
        return heard, errors


def numbers(heard, kind):
    """The words of all lines of a kind behind its name."""
    return [line.split()[1:] for line in heard if line.startswith(kind + " ")]


class ADrive(Bench):
    def test_a_recorded_drive_gives_the_same_poses_live_and_replayed(self):
        heard, errors = self.drive(2, "tf", "reliable", "--record", "drive.mcap")
        poses, transforms = numbers(heard, "pose"), numbers(heard, "transform")
        self.assertGreater(len(poses), 20, "\n".join(heard) + errors)
        self.assertEqual(len(transforms), len(poses))
        self.check_transforms(poses, transforms)
        self.check_covariances(poses)
        self.check_replay(poses)
        self.assertTrue(any(line.startswith("diagnostic 0 [opal: localization] localized") for line in heard))
        width, height, cells, occupied = map(int, numbers(heard, "map")[0])
        self.assertEqual(width * height, cells)
        self.assertGreater(occupied, 1000)

    def check_transforms(self, poses, transforms):
        for pose, transform in zip(poses, transforms):
            self.assertAlmostEqual(float(transform[0]), float(pose[0]) + 1, places=4)
            self.assertEqual(transform[1:3], ["map", "odom"])
            self.assertAlmostEqual(float(transform[5]), 1, places=6)  # a unit quaternion
            self.assertAlmostEqual(float(pose[4]), 1, places=6)

    def check_covariances(self, poses):
        for pose in poses:
            entries = [float(word) for word in pose[6:]]
            self.assertEqual(len(entries), 36)
            self.assertTrue(all(math.isfinite(entry) for entry in entries))
            self.assertTrue(all(entry == 0 for i, entry in enumerate(entries) if i not in (0, 1, 6, 7, 35)))
            self.assertGreater(min(entries[0], entries[7], entries[35]), 0)

    def check_replay(self, poses):
        info = subprocess.run([PROGRAM, "info", "drive.mcap", "--json"], cwd=self.folder, stdout=subprocess.PIPE, check=True)
        topics = {topic["name"]: topic["messages"] for topic in json.loads(info.stdout)["topics"]}
        self.assertEqual(topics["/scan"], SCANS)
        self.assertEqual(topics["/tf"], 2 * SCANS)
        subprocess.run([PROGRAM, "localize", "malaga", "drive.mcap", "--map", MALAGA / "malaga-demo.map.yaml", "-o", "out"],
                       cwd=self.folder, stdout=subprocess.PIPE, check=True)
        replayed = [list(map(float, line.split())) for line in (self.folder / "out/trajectory.tum").read_text().splitlines()
                    if not line.startswith("#")]
        compared = 0
        for pose in poses:
            twins = [row for row in replayed if abs(row[0] - float(pose[0])) < 1e-3]
            for row in twins:
                self.assertAlmostEqual(row[1], float(pose[2]), delta=1e-5)
                self.assertAlmostEqual(row[2], float(pose[3]), delta=1e-5)
                compared += 1
        self.assertGreater(compared, 20)

    def test_odometry_is_taken_from_its_topic_if_there_are_no_transforms_and_best_effort_is_read(self):
        heard, errors = self.drive(3, "odometry", "best_effort")
        self.assertIn("odometry is taken from /odom", errors)
        self.assertGreater(len(numbers(heard, "pose")), 15, errors)


class ALook(Bench):
    def test_a_look_at_a_robot_says_what_is_there_and_writes_a_deployment(self):
        look = self.start("ros2", "--check", "--seconds", "8", "-o", "robot.jsonld")
        time.sleep(2)  # the robot starts later
        self.play(1, "tf", "reliable")
        said, errors = look.communicate(timeout=PATIENCE_S)
        self.assertEqual(look.returncode, 0, said + errors)
        for words in ("/scan", "sensor_msgs/msg/LaserScan", "reliable, volatile", "base_link", "361"):
            self.assertIn(words, said)
        written = json.loads((self.folder / "robot.jsonld").read_text())
        self.assertEqual(written["sensor"]["beams"], 361)
        self.assertAlmostEqual(written["sensor"]["T_base_laser"]["x_m"], 0.78)
        self.assertEqual(written["log_sources"][0]["options"]["scan_topic"], "/scan")

    def test_where_nobody_is_this_is_said_and_the_service_manager_hears_all_the_same(self):
        with socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM) as manager:
            manager.bind(str(self.folder / "notify"))
            manager.settimeout(PATIENCE_S)
            node = self.start("ros2", "malaga", "--map", MALAGA / "malaga-demo.map.yaml",
                              NOTIFY_SOCKET=str(self.folder / "notify"))
            told = [manager.recv(1000).decode() for _ in range(6)]
            code, errors, seconds = self.stop(node)
            told.append(manager.recv(1000).decode())
        self.assertEqual(code, 0, errors)
        self.assertLess(seconds, 1.5)
        self.assertEqual(told[0], "READY=1")
        self.assertIn("WATCHDOG=1", told)
        self.assertIn("nobody publishes anything", errors)
        self.assertIn("waits for scans on /scan", errors)


if __name__ == "__main__":
    unittest.main()

"""What `opal ros2 --check` says of a robot that speaks by Fast DDS, and what options and starts are refused. Loopback only, a domain for each test."""

import json
import re
import socket
import time
import unittest

from bench import LIDAR, MALAGA, PATIENCE_S, Bench, read_config


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

    def test_a_look_at_a_robot_says_where_two_odometries_differ_and_which_is_used(self):
        look = self.start("ros2", "--check", "--seconds", "8")
        self.play(1, "both", "reliable")
        said, errors = look.communicate(timeout=PATIENCE_S)
        self.assertEqual(look.returncode, 0, said + errors)
        told = re.search(r"odometry differs by more than 5 %: the transform on /tf says ([\d.]+) m .*, /odom says ([\d.]+) m "
                         r".*\. Opal uses the transform on /tf", said)
        self.assertTrue(told, said)
        self.assertAlmostEqual(float(told[2]) / float(told[1]), 1.1, places=2)

    def test_a_look_at_a_robot_with_a_3d_lidar_writes_a_deployment_with_a_slice(self):
        look = self.start("ros2", "--check", "--seconds", "8", "-o", "robot.jsonld")
        time.sleep(2)
        self.play(2, "tf", "best_effort", lasers=[LIDAR])
        said, errors = look.communicate(timeout=PATIENCE_S)
        self.assertEqual(look.returncode, 0, said + errors)
        self.assertIn("point clouds /points, frame lidar", said)
        sensor = json.loads((self.folder / "robot.jsonld").read_text())["sensor"]
        self.assertEqual(sensor["topic"], "/points")
        self.assertTrue(sensor["geometry_from_log"])
        self.assertGreater(sensor["slice"]["z_min_m"], 0.1)  # above the floor, below the lamps
        self.assertLess(sensor["slice"]["z_max_m"], 2.2)

    def check_refused(self, code, words, *options):
        process = self.start("ros2", "malaga", "--map", MALAGA / "malaga-demo.map.yaml", *options)
        said, errors = process.communicate(timeout=PATIENCE_S)
        self.assertEqual(process.returncode, code, said + errors)
        self.assertIn(words, said + errors)
        self.assertEqual(list(self.folder.iterdir()), [])

    def test_options_that_would_not_be_used_are_refused_and_files_that_cannot_be_written(self):
        self.check_refused(2, "--seconds requires --check", "--seconds", "4")
        self.check_refused(2, "--out requires --check", "-o", "robot.jsonld")
        self.check_refused(2, "--check", "--check", "--record", "drive.mcap")
        self.check_refused(2, "expected a name that ends in .mcap", "--record", "drive.bag")
        self.check_refused(4, "nope/dir/st.json: cannot be written", "--state", "nope/dir/st.json")
        self.check_refused(3, "2 topics of scans are named (/front, /rear), and 1 laser is described",
                           "--scan-topic", "front", "--scan-topic", "rear")

    def test_a_look_at_nobody_is_a_no(self):
        look = self.start("ros2", "--check", "--seconds", "1", "-o", "robot.jsonld")
        said, errors = look.communicate(timeout=PATIENCE_S)
        self.assertEqual(look.returncode, 1, said + errors)
        self.assertIn("robot.jsonld is not written", errors)

    def test_options_for_other_log_sources_are_told_not_to_be_used(self):
        config = read_config("malaga")
        config["log_sources"] = [{"@type": "opal:Ros1Bag", "options": {"scan_topic": "/front"}}]
        (self.folder / "ros1.jsonld").write_text(json.dumps(config))
        look = self.start("ros2", "ros1.jsonld", "--check", "--seconds", "1")
        self.assertIn("has options for opal:Ros1Bag, and none for opal:McapLog, opal:Ros2Bag", look.communicate(timeout=PATIENCE_S)[1])

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

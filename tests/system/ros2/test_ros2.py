"""A robot that speaks by Fast DDS, with its own types and its own CDR, beside `opal ros2`. Loopback only, a domain for each test."""

import collections
import gzip
import json
import math
import os
import random
import subprocess
import threading
import time
import unittest

from bench import EPOCH_S, LIDAR, MALAGA, PATIENCE_S, PROGRAM, SCANS, Bench, numbers, read_config, replayed


class ADriveChecks(Bench):
    """What holds for every drive."""

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

    def messages_in(self, recording):
        info = subprocess.run([PROGRAM, "info", recording, "--json"], cwd=self.folder, stdout=subprocess.PIPE, check=True)
        return {topic["name"]: topic["messages"] for topic in json.loads(info.stdout)["topics"]}

    def check_replay(self, poses, *words, config="malaga", map=MALAGA / "malaga-demo.map.yaml"):
        """The recording of the live run gives the poses that were published, to the digits that were. @return what the replay says"""
        done = subprocess.run([PROGRAM, "localize", config, "drive.mcap", "--map", map, "-o", "out", *words], cwd=self.folder,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=True)
        rows, compared = replayed(self.folder / "out"), 0
        for pose in poses:
            for row in rows:
                if abs(row[0] - float(pose[0])) > 1e-3:
                    continue
                self.assertAlmostEqual(row[1], float(pose[2]), delta=1e-5)
                self.assertAlmostEqual(row[2], float(pose[3]), delta=1e-5)
                compared += 1
        self.assertGreater(compared, 0.9 * len(poses))
        return done.stdout

    def check_every_stamp_has_a_transform(self, heard):
        """Nav2 asks for the transform at the stamp of the newest odometry. @return at how many it was asked for"""
        until, asked = None, 0
        for line in heard:
            words = line.split()
            if words[0] == "transform":
                until = float(words[1])
            elif words[0] == "moved" and until is not None:
                asked += 1
                self.assertLessEqual(float(words[1]), until, line)
        return asked


class ADrive(ADriveChecks):
    def test_a_recorded_drive_gives_the_same_poses_live_and_replayed(self):
        heard, errors = self.drive(2, "tf", "reliable", "--record", "drive.mcap")
        poses, transforms = numbers(heard, "pose"), numbers(heard, "transform")
        self.assertGreater(len(poses), 20, "\n".join(heard) + errors)
        self.assertEqual(len(transforms), len(poses))
        self.check_transforms(poses, transforms)
        self.check_covariances(poses)
        self.assertEqual(self.messages_in("drive.mcap")["/scan"], SCANS)
        self.assertEqual(self.messages_in("drive.mcap")["/tf"], 2 * SCANS)
        self.check_replay(poses)
        self.assertRegex(errors, r"(?m)^ros2: localized at x -?[\d.]+ m, y ")
        self.assertTrue(any(line.startswith("diagnostic 0 [opal: localization] localized") for line in heard))
        width, height, cells, occupied = map(int, numbers(heard, "map")[0])
        self.assertEqual(width * height, cells)
        self.assertGreater(occupied, 1000)

    def test_what_a_person_says_is_in_the_recording_and_a_replay_has_it(self):
        said = {36: ["FORGET 0 0 0 4.33", "HINT 8.9 -10.7 0 4.45"]}  # the next scan is at 4.5
        heard, errors = self.drive(1, "tf", "reliable", "--record", "drive.mcap", said=said)
        poses = numbers(heard, "pose")
        self.assertIn("asked on /opal/forget to forget everything", errors)
        self.assertGreater(len(poses), 10, "\n".join(heard) + errors)
        recorded = self.messages_in("drive.mcap")
        self.assertEqual((recorded["/initialpose"], recorded["/opal/forget"]), (1, 1))
        self.assertNotIn("are not taken", self.check_replay(poses, "--log-set", "hint_topic=/initialpose"))
        events = [json.loads(line) for line in (self.folder / "out/events.jsonl").read_text().splitlines()]
        self.assertIn("after all was forgotten", [event.get("query") for event in events])
        unasked = subprocess.run([PROGRAM, "localize", "malaga", "drive.mcap", "--map", MALAGA / "malaga-demo.map.yaml", "-o", "unasked"],
                                 cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=True)
        self.assertIn("hints of the pose on /initialpose are not taken", unasked.stdout)

    def test_what_a_drive_says_of_the_map_is_kept_while_it_is_driven(self):
        self.drive(2, "tf", "reliable", "--evidence", "evidence.json")
        drives = json.loads((self.folder / "evidence.json").read_text())
        self.assertEqual([drive["drive"].split(", ")[-1] for drive in drives], ["part 1"])
        self.assertGreater(drives[0]["learned_m"], 1)
        learned = subprocess.run([PROGRAM, "learn", MALAGA / "malaga-demo.map.yaml", "evidence.json", "-o", "learned.jsonld"], cwd=self.folder,
                                 stdout=subprocess.PIPE, text=True, check=True)
        self.assertRegex(learned.stdout, r"[1-9]\d* objects stand where the map says")

    def test_a_second_recording_leaves_the_first_one_as_it_is(self):
        (self.folder / "drive.mcap").write_text("of yesterday")
        errors = self.drive(3, "tf", "reliable", "--record", "drive.mcap")[1]
        self.assertIn("drive.mcap is there already: what is received goes into drive-2.mcap", errors)
        self.assertEqual((self.folder / "drive.mcap").read_text(), "of yesterday")
        self.assertEqual(self.messages_in("drive-2.mcap")["/scan"], SCANS)

    def test_odometry_is_taken_from_its_topic_if_there_are_no_transforms_and_best_effort_is_read(self):
        heard, errors = self.drive(3, "odometry", "best_effort")
        self.assertIn("odometry is taken from /odom", errors)
        self.assertGreater(len(numbers(heard, "pose")), 15, errors)

    def test_a_3d_lidar_is_localized_by_a_slice_of_its_clouds(self):
        config = read_config("malaga")
        config["sensor"] = {"topic": "/points", "geometry_from_log": True, "beams": 361, "angle_min_rad": -1.5707963268,
                            "angle_increment_rad": 0.00872664626, "slice": {"z_min_m": 0.3, "z_max_m": 1.8}}
        (self.folder / "lidar.jsonld").write_text(json.dumps(config))
        heard, errors = self.drive(2, "tf", "reliable", "--record", "drive.mcap", config="lidar.jsonld", lasers=[LIDAR])
        poses = numbers(heard, "pose")
        self.assertGreater(len(poses), 20, "\n".join(heard) + errors)
        self.assertEqual(self.messages_in("drive.mcap")["/points"], SCANS)
        self.check_replay(poses, config="lidar.jsonld")
        told = subprocess.run([PROGRAM, "info", "drive.mcap"], cwd=self.folder, stdout=subprocess.PIPE, check=True, text=True)
        for words in ("point clouds /points, frame lidar", "4 x 361 points with x FLOAT32", "height 1.00 m", "suggested slice"):
            self.assertIn(words, told.stdout)
        self.check_like_planar(poses)

    def check_like_planar(self, poses):
        """The poses are those that the log's own scans give."""
        subprocess.run([PROGRAM, "localize", "malaga", MALAGA / "malaga-demo.log.gz", "--map", MALAGA / "malaga-demo.map.yaml",
                        "-o", "planar"], cwd=self.folder, stdout=subprocess.PIPE, check=True)
        planar, compared = replayed(self.folder / "planar"), 0
        for pose in poses:
            for row in planar:
                if abs(row[0] + EPOCH_S - float(pose[0])) < 2e-3:
                    self.assertLess(math.hypot(row[1] - float(pose[2]), row[2] - float(pose[3])), 0.1)
                    compared += 1
        self.assertGreater(compared, 20)


class TwoLasers(ADriveChecks):
    def test_two_lasers_in_real_time_give_the_poses_of_the_replay_and_a_transform_for_every_stamp(self):
        subprocess.run([PROGRAM, "simulate", MALAGA / "malaga-demo.map.yaml", "-o", "runs/two", "--config", "two_lasers",
                        "--drives", "1", "--distance", "20", "--seed", "3"], cwd=self.folder, stdout=subprocess.PIPE, check=True)
        lasers = self.write_deployment()
        map = self.folder / "runs/two.map.jsonld"
        heard, errors = self.drive(1, "tf", "reliable", "--record", "drive.mcap", config="robot.jsonld", map=map,
                                   lasers=lasers, log=self.folder / "runs/two.log.gz")
        poses = numbers(heard, "pose")
        self.assertGreater(len(poses), 50, "\n".join(heard) + errors)
        scans = self.scans_in_log()
        recorded = self.messages_in("drive.mcap")
        self.assertEqual((recorded["/scan_front"], recorded["/scan_rear"]), (scans["FLASER"], scans["RLASER"]))
        self.check_transforms(poses, numbers(heard, "transform"))
        self.check_replay(poses, config="robot.jsonld", map=map)
        moved = len(numbers(heard, "moved"))
        self.assertGreater(self.check_every_stamp_has_a_transform(heard), moved / 2)

    def drive_without(self, is_missing):
        """A drive in which some scans of the rear laser are missing. @return poses, what was said, when it began"""
        subprocess.run([PROGRAM, "simulate", MALAGA / "malaga-demo.map.yaml", "-o", "runs/two", "--config", "two_lasers",
                        "--drives", "1", "--distance", "20", "--seed", "3"], cwd=self.folder, stdout=subprocess.PIPE, check=True)
        lines = gzip.decompress((self.folder / "runs/two.log.gz").read_bytes()).splitlines(keepends=True)
        begun_s = next(float(line.split()[-3]) for line in lines if line.startswith(b"FLASER"))
        kept = [line for line in lines if not (line.startswith(b"RLASER") and is_missing(float(line.split()[-3]) - begun_s))]
        (self.folder / "runs/two.log.gz").write_bytes(gzip.compress(b"".join(kept)))
        lasers = self.write_deployment()
        heard, errors = self.drive(1, "tf", "reliable", "--record", "drive.mcap", config="robot.jsonld",
                                   map=self.folder / "runs/two.map.jsonld", lasers=lasers, log=self.folder / "runs/two.log.gz")
        return numbers(heard, "pose"), errors, begun_s + EPOCH_S

    def test_a_laser_that_never_sends_is_named_and_the_other_one_goes_on_alone(self):
        poses, errors, _ = self.drive_without(lambda since_s: True)
        self.assertGreater(len(poses), 20, errors)
        self.assertIn("localization goes on without the laser of /scan_rear", errors)

    def test_a_laser_that_appears_after_ten_seconds_is_used_and_the_robot_is_localized_again(self):
        poses, errors, begun_s = self.drive_without(lambda since_s: since_s < 10)
        self.assertIn("localization goes on without the laser of /scan_rear", errors)
        self.assertIn("scans of RLASER have come: localization begins anew with this laser", errors)
        self.assertTrue(any(float(pose[0]) < begun_s + 10 for pose in poses), errors)
        self.assertGreater(sum(float(pose[0]) > begun_s + 11 for pose in poses), 20, errors)

    def write_deployment(self):
        """Beams and mounts come from the robot. @return the robot's lasers"""
        config, lasers = read_config("two_lasers"), []
        for sensor in config["sensor"]:
            mount = sensor.pop("T_base_laser")
            lasers.append(",".join(map(str, (
                sensor["frame"], sensor["frame"], sensor["topic"], "scan", sensor.pop("angle_min_rad"),
                sensor.pop("angle_increment_rad"), 81, sensor.pop("sweep_s"), mount["x_m"], mount["y_m"], mount["heading_rad"]))))
            sensor.pop("beams")
            sensor["geometry_from_log"] = True
        (self.folder / "robot.jsonld").write_text(json.dumps(config))
        return lasers

    def scans_in_log(self):
        lines = subprocess.run(["gzip", "-dc", "runs/two.log.gz"], cwd=self.folder, stdout=subprocess.PIPE, check=True).stdout
        return collections.Counter(line.split()[0].decode() for line in lines.splitlines())


class AKilledRecorder(ADriveChecks):
    """kill -9 at random moments; OPAL_KILLS says how often."""

    def killed_at_s(self, after_s):
        """Records a robot that drives on. Killed so long after the first chunk is in the file. @return when, by this machine's clock"""
        drive = self.folder / "drive.mcap"
        drive.unlink(missing_ok=True)
        node = self.start("ros2", "malaga", "--map", MALAGA / "malaga-demo.map.yaml", "--record", "drive.mcap")
        moments = []
        def kill():
            begin = time.monotonic()
            while not (drive.exists() and drive.stat().st_size > 0) and time.monotonic() < begin + PATIENCE_S:
                time.sleep(0.05)
            time.sleep(after_s)
            node.kill()
            moments.append(time.time())
        killer = threading.Thread(target=kill)
        killer.start()
        self.play(1, "tf", "reliable")
        killer.join()
        node.communicate(timeout=PATIENCE_S)
        return moments[0]

    def test_a_recording_holds_all_but_the_last_second_and_a_half(self):
        drawn = random.Random(1)
        for _ in range(int(os.environ.get("OPAL_KILLS", "2"))):
            killed_s = self.killed_at_s(drawn.uniform(0, 6))
            info = subprocess.run([PROGRAM, "info", "drive.mcap", "--json"], cwd=self.folder, capture_output=True, text=True, check=True)
            self.assertIn("without a footer", info.stdout + info.stderr)
            self.assertGreater(json.loads(info.stdout)["last_s"], killed_s - 1.5, info.stdout)
            self.assertGreater(self.messages_in("drive.mcap")["/scan"], 0)


if __name__ == "__main__":
    unittest.main()

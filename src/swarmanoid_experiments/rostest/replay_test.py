#!/usr/bin/python3
"""Controllers in other processes, in lockstep over topics, recorded by the space: a replay repeats their commands, and the
tables contain them."""

import csv
import os
import subprocess
import sys
import tempfile
import unittest

import rospkg
import rospy
import rostest

from participants import CONTROLLERS, Participant, set_source
from space_client import Space

BAG = os.path.join(rospkg.get_ros_home(), "replay_test.bag")  # as in space.launch


class ReplayTest(unittest.TestCase):
    def setUp(self):
        self.space = Space()
        self.participants = {}

    def tearDown(self):
        for participant in self.participants.values():
            participant.end()

    def test_a_run_with_a_reset_and_a_controller_that_was_started_again(self):
        self.assertTrue(set_source(["fb_1", "eb"], "remote").success)
        self.participants = {robot: Participant(robot) for robot in ("fb_1", "eb")}
        self.assertTrue(self.space.step(30).success)
        self.space.restart()  # all controllers are in process
        self.assertTrue(self.space.step(40).success)
        self.assertTrue(set_source(["fb_1", "eb"], "remote").success)
        self.assertTrue(self.space.step(20).success)
        self.participants["eb"].kill()
        self.participants["eb"] = Participant("eb")  # the tick waits for it
        ended = self.space.step(10**6)
        self.assertEqual("the run finished before all of them were made", ended.message)

        replay = subprocess.run(["rosrun", "swarmanoid_recording", "replay", BAG], stdout=subprocess.PIPE,
                                stderr=subprocess.PIPE, universal_newlines=True, check=False)
        self.assertEqual("", replay.stderr)
        starts = {robot: [f"start 1 (run 0): all 30", f"start 2 (run 1): all {ended.tick}"] for robot in CONTROLLERS}
        starts["fb_1"][1:] = ["start 2 (run 1): all 40", f"start 3 (run 1): all {ended.tick - 40}"]
        starts["eb"][1:] = ["start 2 (run 1): all 40", "start 3 (run 1): all 20",
                            f"start 4 (run 1): all {ended.tick - 60}"]
        expected = [f"{robot}, {start} ticks are equal" for robot in sorted(starts) for start in starts[robot]]
        self.assertEqual(expected, replay.stdout.splitlines())
        self.assertEqual(0, replay.returncode)
        self.check_tables(ended.tick)

    def check_tables(self, last_tick):
        with tempfile.TemporaryDirectory() as folder:
            tables = subprocess.run(["rosrun", "swarmanoid_experiments", "bag_to_csv.py", BAG, "--out", folder],
                                    stdout=subprocess.PIPE, stderr=subprocess.PIPE, universal_newlines=True, check=False)
            self.assertEqual((0, f"{folder}: poses.csv, events.csv, trajectories.png; 2 runs, 0 gaps in the ticks\n", ""),
                             (tables.returncode, tables.stdout, tables.stderr))
            with open(os.path.join(folder, "poses.csv"), newline="") as file:
                ticks = [(int(row["run"]), int(row["tick"])) for row in csv.DictReader(file) if row["name"] == "fb_1"]
            with open(os.path.join(folder, "events.csv"), newline="") as file:
                joined = {(row["run"], row["entity"]) for row in csv.DictReader(file) if row["kind"] == "participant_joined"}
        self.assertEqual([(0, tick) for tick in range(31)] + [(1, tick) for tick in range(last_tick + 1)], ticks)
        self.assertLessEqual({("0", "fb_1_controller"), ("0", "eb_controller"), ("1", "eb_controller")}, joined)


if __name__ == "__main__":
    rospy.init_node("replay_test")
    rostest.rosrun("swarmanoid_experiments", "replay", ReplayTest, sys.argv)

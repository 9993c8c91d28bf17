#!/usr/bin/python3
"""Controllers in other processes, in lockstep over topics, recorded by the space: replayed they do the same."""

import os
import subprocess
import sys
import unittest

import rospkg
import rospy
import rostest

from participants import CONTROLLERS, Participant, set_source
from space_client import Space

BAG = os.path.join(rospkg.get_ros_home(), "replay_test.bag")  # as space.launch says


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

        replay = subprocess.run(["rosrun", "swarmanoid_interface", "replay", BAG], stdout=subprocess.PIPE,
                                stderr=subprocess.PIPE, universal_newlines=True, check=False)
        self.assertEqual("", replay.stderr)
        starts = {robot: [f"start 1 (run 0): all 30", f"start 2 (run 1): all {ended.tick}"] for robot in CONTROLLERS}
        starts["fb_1"][1:] = ["start 2 (run 1): all 40", f"start 3 (run 1): all {ended.tick - 40}"]
        starts["eb"][1:] = ["start 2 (run 1): all 40", "start 3 (run 1): all 20",
                            f"start 4 (run 1): all {ended.tick - 60}"]
        expected = [f"{robot}, {start} ticks are equal" for robot in sorted(starts) for start in starts[robot]]
        self.assertEqual(expected, replay.stdout.splitlines())
        self.assertEqual(0, replay.returncode)


if __name__ == "__main__":
    rospy.init_node("replay_test")
    rostest.rosrun("swarmanoid_experiments", "replay", ReplayTest, sys.argv)

#!/usr/bin/python3
"""Controllers in other processes, in lockstep over topics: the bits of a run with all controllers in process."""

import os
import sys
import time
import unittest

import rospkg
import rospy
import rostest
from swarmanoid_msgs.msg import CommandFrame
from swarmanoid_msgs.srv import Register, RegisterRequest

from participants import CONTROLLERS, Participant, set_source
from space_client import TIMEOUT, Space, run_without_ros

HASHES = os.path.join(rospkg.get_ros_home(), "lockstep_test.txt")  # as in space.launch


class LockstepTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.space = Space()

    def setUp(self):
        self.space.restart()
        self.participants = []

    def tearDown(self):
        for participant in self.participants:
            participant.end()

    def compare(self, robots):
        self.assertTrue(set_source(list(robots), "remote").success)
        self.participants = [Participant(robot) for robot in robots]
        self.assertTrue(self.space.step(10).success)  # the first tick waits for all of them
        start = time.monotonic()
        ticks = self.finish()
        print(f"{len(robots)} processes: {ticks / (time.monotonic() - start):.0f} ticks/s")

    def finish(self):
        """@return ticks to the end; compares the run with that of the program, tick by tick"""
        before = self.space.step(1).tick
        ended = self.space.step(10**6)
        self.assertEqual("the run finished before all of them were made", ended.message)
        with open(HASHES) as file:
            self.assertEqual(run_without_ros(self, "object_retrieval", 1), file.read().splitlines())
        return ended.tick - before

    def test_all_four_elsewhere(self):
        self.compare(CONTROLLERS)

    def test_two_here_and_two_elsewhere(self):
        self.compare(["fb_2", "eb"])

    def test_a_reset_starts_them_anew(self):
        self.assertTrue(set_source(["eb"], "remote").success)
        self.participants = [Participant("eb")]
        self.assertTrue(self.space.step(20).success)
        self.space.restart()
        self.assertTrue(set_source(["eb"], "remote").success)
        self.finish()

    def test_registrations_are_refused_with_a_reason(self):
        register = rospy.ServiceProxy("/space/register", Register)
        register.wait_for_service(TIMEOUT)
        for request, reason in (
                ({"participant": "x", "robots": ["fb_1"]},
                 "robot 'fb_1' is not commanded from another process; those are: none"),
                ({"participant": "/x", "robots": ["fb_1"]},
                 "participant: found '/x', allowed: a name without a leading slash"),
                ({"participant": "x", "robots": ["fb_1"], "policy": "hope"},
                 "policy: found 'hope', allowed: wait, skip, stop"),
                ({"participant": "x", "robots": ["fb_1"], "connection": 77},
                 "connection: found 77, allowed: 0, or the number of a connection to ~lockstep_socket that is open")):
            answer = register(RegisterRequest(**request))
            self.assertFalse(answer.success)
            self.assertEqual(reason, answer.message)
        self.assertEqual("source: found 'topic', allowed: controller, remote, topics, none",
                         set_source(["fb_1"], "topic").message)

    def test_a_process_ends_when_it_is_refused(self):
        self.assertEqual(4, Participant("fb_1").wait())

    def test_commands_from_elsewhere_move_nobody(self):
        self.assertTrue(set_source(["eb"], "remote").success)
        self.participants = [Participant("eb", use_topics=True)]
        self.assertTrue(self.space.step(5).success)
        intruder = rospy.Publisher("/space/participants/eb_controller/commands", CommandFrame, queue_size=10)
        while intruder.get_num_connections() == 0:
            time.sleep(0.01)
        for tick in range(10):
            intruder.publish(CommandFrame(session=1, tick=tick, data=b"\0"))
            intruder.publish(CommandFrame(session=99, tick=tick, data=b"\0"))
        time.sleep(0.2)
        self.finish()


if __name__ == "__main__":
    rospy.init_node("lockstep_test")
    rostest.rosrun("swarmanoid_experiments", "lockstep", LockstepTest, sys.argv)

#!/usr/bin/python3
"""A process that commands a robot is killed and restarted, under each policy; the space names it."""

import sys
import threading
import time
import unittest

import rospy
import rostest
from swarmanoid_msgs.msg import Event, RunResult

from participants import LockstepStatus, Participant, set_source
from space_client import Collector, Space

PATIENCE = 1.0  # [s] of wall time for each answer of the process except its first one


class LockstepPoliciesTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.space = Space()
        cls.events = Collector("/space/events", Event)
        cls.events.wait_for_publisher()

    def setUp(self):
        self.space.restart()
        self.participants = []

    def tearDown(self):
        for participant in self.participants:
            participant.end()

    def start(self, **parameters):
        self.participants.append(Participant("fb_1", timeout=PATIENCE, **parameters))
        return self.participants[-1]

    def kill_in_a_run(self, policy):
        """@return the process, killed after some ticks"""
        self.assertTrue(set_source(["fb_1"], "remote").success)
        participant = self.start(policy=policy)
        self.assertTrue(self.space.step(20).success)
        self.events.clear()
        participant.kill()

    def step_in_time(self):
        """@return the answer to 20 ticks, one of which waits for the process for the maximum time"""
        start = time.monotonic()
        answer = self.space.step(20)
        self.assertLess(time.monotonic() - start, PATIENCE + 1.0)
        return answer

    def assert_event(self, kind, text):
        self.assertIsNotNone(self.events.wait_for(
            lambda event: (event.kind, event.entity, event.text) == (kind, "fb_1_controller", text)), text)

    def test_1_wait(self):
        self.kill_in_a_run("wait")
        answers = []
        stepping = threading.Thread(target=lambda: answers.append(self.space.step(20)))
        stepping.start()
        self.assertTrue(LockstepStatus().wait_for("missing: 'fb_1_controller'"))
        self.assertEqual([], answers)
        self.start(policy="wait")
        stepping.join(15.0)
        self.assertTrue(answers[0].success)
        self.assertEqual(40, answers[0].tick)
        self.assert_event(Event.PARTICIPANT_LATE, f"no answer in tick 20 ({PATIENCE:g} s); policy wait")
        self.assert_event(Event.PARTICIPANT_JOINED, "again, for fb_1")

    def test_2_skip(self):
        self.kill_in_a_run("skip")
        self.assertTrue(self.step_in_time().success)
        self.assert_event(Event.PARTICIPANT_LATE, f"no answer in tick 20 ({PATIENCE:g} s); policy skip")
        self.assertTrue(LockstepStatus().wait_for("missing: 'fb_1_controller'"))
        self.start(policy="wait")  # so that the next test's first tick waits for its own process
        self.assertTrue(LockstepStatus().wait_for("1 participants"))
        self.assertTrue(self.space.step(20).success)
        self.assert_event(Event.PARTICIPANT_JOINED, "again, for fb_1")

    def test_3_stop(self):
        results = Collector("/space/result", RunResult)
        self.kill_in_a_run("stop")
        reason = f"tick 20: participant 'fb_1_controller': no answer in tick 20 ({PATIENCE:g} s); policy stop"
        self.assertEqual("the run has stopped: " + reason, self.step_in_time().message)
        result = results.wait_for(lambda r: True)
        self.assertFalse(result.finished)
        self.assertEqual(reason, result.message)


if __name__ == "__main__":
    rospy.init_node("lockstep_policies_test")
    rostest.rosrun("swarmanoid_experiments", "lockstep_policies", LockstepPoliciesTest, sys.argv)

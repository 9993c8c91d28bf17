#!/usr/bin/python3
"""The conformance test with its controllers in other processes, in lockstep over topics."""

import sys
import unittest

import rospy
import rostest
from swarmanoid_msgs.msg import RunResult

from participants import Participant, set_source
from space_client import Collector, Space

TESTED = ("fb", "eb", "hb")


class ConformanceTest(unittest.TestCase):
    def setUp(self):
        self.space = Space()
        self.participants = []

    def tearDown(self):
        for participant in self.participants:
            participant.end()

    def test_lockstep_over_topics_passes(self):
        self.assertTrue(set_source(TESTED, "remote").success)
        self.participants = [Participant(robot, controller="conformance") for robot in TESTED]
        results = Collector("/space/result", RunResult)
        self.space.step(10**6)
        result = results.wait_for(lambda message: message.ticks > 0)
        self.assertIsNotNone(result)
        verdicts = {metric.name: metric.value for metric in result.metrics}
        self.assertEqual({robot: "passed" for robot in TESTED + ("fb_observer", "eb_observer", "hb_observer")}, verdicts)
        self.assertTrue(result.judged and result.success)
        self.assertEqual([], result.failed_robots)


if __name__ == "__main__":
    rospy.init_node("conformance_test")
    rostest.rosrun("swarmanoid_experiments", "conformance", ConformanceTest, sys.argv)

#!/usr/bin/python3
"""Nodelets that fail or are unloaded: the space names them, stops cleanly if it needs them, and the manager continues."""

import sys
import unittest

import rosgraph
import rospy
import rostest
from diagnostic_msgs.msg import DiagnosticArray
from swarmanoid_msgs.msg import RunResult

from space_client import Collector, Space, load, unload


class UnloadTest(unittest.TestCase):
    @staticmethod
    def robot_topics():
        published = rosgraph.Master("/unload_test").getSystemState()[0]
        return [topic for topic, _ in published if topic.startswith("/fb_1/")]

    def test_1_a_part_without_a_space_does_not_load(self):
        self.assertFalse(load("/lonely", "swarmanoid_ros/EngineNodelet"))
        self.assertFalse(load("/lonely", "swarmanoid_controllers/diffusion"))

    def test_2_a_space_with_a_bad_parameter_does_not_load(self):
        rospy.set_param("/second/experiment", "object_retrieval")
        rospy.set_param("/second/sed", 3)
        self.assertFalse(load("/second", "swarmanoid_ros/SpaceNodelet"))
        rospy.set_param("/third/experiment", "object_retrievl")
        self.assertFalse(load("/third", "swarmanoid_ros/SpaceNodelet"))

    def test_3_the_run_does_not_depend_on_who_looks_at_it(self):
        space = Space()
        self.assertTrue(self.robot_topics())
        self.assertTrue(unload("/fb_1/devices"))
        self.assertFalse(self.robot_topics())
        self.assertTrue(space.step(3).success)

    def test_4_without_an_engine_the_run_stops(self):
        space = Space()
        results = Collector("/space/result", RunResult)
        diagnostics = Collector("/diagnostics", DiagnosticArray)
        self.assertTrue(unload("/space/engines/sky"))
        reason = "engine 'sky': its nodelet was unloaded"
        result = results.wait_for(lambda r: True)
        self.assertFalse(result.finished)
        self.assertEqual(reason, result.message)
        answer = space.step(1)
        self.assertFalse(answer.success)
        self.assertEqual("the run has stopped: " + reason, answer.message)
        self.assertIsNotNone(diagnostics.wait_for(
            lambda array: any(s.level == 2 and reason in s.message for s in array.status)))

    def test_5_a_space_can_be_unloaded_and_loaded_again(self):
        self.assertTrue(unload("/space"))
        self.assertTrue(load("/space", "swarmanoid_ros/SpaceNodelet"))
        self.assertTrue(Space().step(2).success)


if __name__ == "__main__":
    rospy.init_node("unload_test")
    rostest.rosrun("swarmanoid_experiments", "unload", UnloadTest, sys.argv)

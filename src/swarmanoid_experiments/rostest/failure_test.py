#!/usr/bin/python3
"""A controller that throws stops only its own robot; topics name the robot and the reason."""

import sys
import unittest

import rospy
import rostest
from diagnostic_msgs.msg import DiagnosticArray
from swarmanoid_msgs.msg import Event, RunResult, WorldState

from space_client import Collector, Space


class FailureTest(unittest.TestCase):
    def test_only_the_robot_stops_whose_controller_throws(self):
        space = Space()
        states = Collector("/space/world_state", WorldState)
        events = Collector("/space/events", Event)
        results = Collector("/space/result", RunResult)
        diagnostics = Collector("/diagnostics", DiagnosticArray)
        for collector in (states, events, results):
            collector.wait_for_publisher()
        space.step(10**6)

        failure = events.wait_for(lambda event: event.kind == Event.CONTROLLER_FAILED)
        self.assertIsNotNone(failure, "no event")
        self.assertEqual("fb_2", failure.entity)
        self.assertIn("told to", failure.text)

        result = results.wait_for(lambda r: True)
        self.assertTrue(result.finished)
        self.assertEqual(60, result.ticks)
        self.assertEqual(["fb_2"], result.failed_robots)
        self.assertIsNotNone(diagnostics.wait_for(
            lambda array: any(s.level == 2 and "controllers failed: 1" in s.message for s in array.status)))

        last = states.wait_for(lambda state: state.tick == 60)
        at_failure = states.wait_for(lambda state: state.tick == failure.tick + 1)
        for robot, moves in (("fb_1", True), ("fb_2", False), ("fb_3", True)):
            i = last.names.index(robot)
            self.assertEqual(moves, last.poses[i].position.x > at_failure.poses[i].position.x, robot)


if __name__ == "__main__":
    rospy.init_node("failure_test")
    rostest.rosrun("swarmanoid_experiments", "failure", FailureTest, sys.argv)

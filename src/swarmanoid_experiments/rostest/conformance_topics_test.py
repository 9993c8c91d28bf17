#!/usr/bin/python3
"""The conformance test of simulated robots over standard topics, in real time."""

import sys
import unittest

import rospy
import rostest

from participants import set_source
from space_client import Space
from topic_hosts import ConformanceHosts

ROBOTS = {"fb": ("footbot", {}), "eb": ("eyebot", {"laser_height": 1.35, "ceiling": True}),
          "hb": ("handbot", {"ceiling": True, "board": True})}


class ConformanceTopicsTest(unittest.TestCase):
    def test_all_robots_pass(self):
        space = Space()
        self.assertTrue(set_source(list(ROBOTS), "topics").success)
        hosts = ConformanceHosts(ROBOTS)
        self.addCleanup(hosts.end)
        rospy.wait_for_message("/fb/controller/start", rospy.AnyMsg, 20)
        self.assertTrue(space.resume().success)
        for robot in ROBOTS:
            verdict = hosts.verdict(robot)
            print(robot, verdict)
            self.assertEqual("passed", verdict.get("conformance"), verdict)


if __name__ == "__main__":
    rospy.init_node("conformance_topics_test")
    rostest.rosrun("swarmanoid_experiments", "conformance_topics", ConformanceTopicsTest, sys.argv)

#!/usr/bin/python3
"""One seed, one run: under ROS with and without subscribers, as without ROS."""

import os
import sys
import unittest

import rospkg
import rospy
import rostest
from rosgraph_msgs.msg import Clock
from swarmanoid_msgs.msg import Event, Performance, WorldState
from tf2_msgs.msg import TFMessage
from visualization_msgs.msg import MarkerArray

from space_client import Collector, Space, run_without_ros

HASHES = os.path.join(rospkg.get_ros_home(), "same_bits_test.txt")  # as in space.launch
TOPICS = {"/clock": Clock, "/tf": TFMessage, "/tf_static": TFMessage, "/space/world_state": WorldState,
          "/space/markers": MarkerArray, "/space/markers_static": MarkerArray, "/space/events": Event,
          "/space/performance": Performance}


class SameBitsTest(unittest.TestCase):
    @staticmethod
    def hashes():
        """Returns the hashes of the last run; complete once it is finished."""
        with open(HASHES) as file:
            return file.read().splitlines()

    def test_every_tick_has_the_hash_that_it_has_without_ros(self):
        expected = run_without_ros(self, "object_retrieval", 1)
        space = Space()
        alone = space.step(6000)
        self.assertEqual("the run finished before all of them were made", alone.message)
        self.assertEqual(expected, self.hashes(), "with nobody listening")
        space.restart()
        collectors = [Collector(topic, kind) for topic, kind in TOPICS.items()]
        self.assertIsNotNone(collectors[3].wait_for(lambda state: True), "nobody is served")
        heard = space.step(6000)
        self.assertEqual(alone.tick, heard.tick)
        self.assertIsNotNone(collectors[3].wait_for(lambda state: state.tick == heard.tick))
        self.assertEqual(alone.tick + 1, len(expected))
        self.assertEqual(expected, self.hashes(), "with everybody listening, after a reset")


if __name__ == "__main__":
    rospy.init_node("same_bits_test")
    rostest.rosrun("swarmanoid_experiments", "same_bits", SameBitsTest, sys.argv)

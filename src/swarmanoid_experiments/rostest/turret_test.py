#!/usr/bin/python3
"""The turret of a footbot as a topic and as a frame."""

import sys
import unittest

import rospy
import rostest
from sensor_msgs.msg import JointState
from tf2_msgs.msg import TFMessage

from space_client import Collector, Space


class TurretTest(unittest.TestCase):
    def test_the_joint_has_a_topic_and_a_frame(self):
        space = Space()
        states = Collector("/fb/turret/state", JointState)
        transforms = Collector("/tf", TFMessage)
        states.wait_for_publisher()
        transforms.wait_for_publisher()
        self.assertTrue(space.step(20).success)
        state = states.wait_for(lambda message: message.header.stamp.to_sec() > 2.5)
        self.assertEqual("fb/base_link", state.header.frame_id)
        self.assertEqual(["turret"], state.name)
        self.assertEqual([1, 1, 1], [len(state.position), len(state.velocity), len(state.effort)])
        self.assertAlmostEqual(0.0, state.position[0], 2)
        frames = transforms.wait_for(lambda message: any(t.child_frame_id == "fb/turret" for t in message.transforms))
        parents = {t.child_frame_id: t.header.frame_id for t in frames.transforms}
        self.assertEqual("fb/base_link", parents["fb/turret"])


if __name__ == "__main__":
    rospy.init_node("turret_test")
    rostest.rosrun("swarmanoid_experiments", "turret", TurretTest, sys.argv)

#!/usr/bin/python3
"""A handbot's arms, hands and rope as topics, frames and markers."""

import sys
import unittest

import rospy
import rostest
from sensor_msgs.msg import JointState
from swarmanoid_msgs.msg import HandsState, RopeState
from tf2_msgs.msg import TFMessage
from visualization_msgs.msg import MarkerArray

from space_client import Collector, Space

JOINTS = [f"{side}_{joint}" for side in ("left", "right") for joint in ("shoulder", "elbow", "wrist")]


class ClimbingTest(unittest.TestCase):
    def test_what_a_handbot_does_can_be_heard(self):
        space = Space()
        joints = Collector("/hb_1/joint_states", JointState)
        hands = Collector("/hb_1/hands/state", HandsState)
        ropes = Collector("/hb_1/rope/state", RopeState)
        transforms = Collector("/tf", TFMessage)
        markers = Collector("/space/markers", MarkerArray)
        for collector in (joints, hands, ropes, transforms, markers):
            collector.wait_for_publisher()
        self.assertTrue(space.step(200).success)  # it has climbed, and holds the box

        joint = joints.wait_for(lambda message: message.position[0] < -1.4)
        self.assertEqual("hb_1/base_link", joint.header.frame_id)
        self.assertEqual(JOINTS, joint.name)
        self.assertEqual([6, 6, 6], [len(joint.position), len(joint.velocity), len(joint.effort)])
        rope = ropes.wait_for(lambda message: message.attached and message.length < 1.6)
        self.assertEqual("hb_1/rope_launcher", rope.header.frame_id)
        self.assertGreater(rope.tension, 20.0)
        hand = hands.wait_for(lambda message: message.left_holding)
        self.assertFalse(hand.right_holding)
        frames = transforms.wait_for(lambda message: any(t.child_frame_id == "hb_1/left_hand" for t in message.transforms))
        parents = {t.child_frame_id: t.header.frame_id for t in frames.transforms}
        self.assertEqual("hb_1/left_forearm", parents["hb_1/left_hand"])
        self.assertEqual("hb_1/body", parents["hb_1/left_upper_arm"])
        shown = markers.wait_for(lambda message: any(marker.ns == "ropes" and marker.points for marker in message.markers))
        line = next(marker for marker in shown.markers if marker.ns == "ropes").points
        self.assertAlmostEqual(2.5, line[1].z, 6)  # at the ceiling


if __name__ == "__main__":
    rospy.init_node("climbing_test")
    rostest.rosrun("swarmanoid_experiments", "climbing", ClimbingTest, sys.argv)

#!/usr/bin/python3
"""Rules of tf: no frame twice with one stamp, no leading slash, one parent each, no messages while paused."""

import sys
import time
import unittest

import rospy
import rostest
from geometry_msgs.msg import PoseStamped
from swarmanoid_msgs.msg import EntityPose
from tf2_msgs.msg import TFMessage

from space_client import Collector, Space


class TransformsTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.space = Space()
        cls.moving = Collector("/tf", TFMessage)
        cls.fixed = Collector("/tf_static", TFMessage)
        cls.moving.wait_for(lambda m: True)
        cls.fixed.wait_for(lambda m: True)
        # single steps, a run of many ticks, a reset: all cases that could send one stamp twice
        for _ in range(5):
            cls.space.step(1)
        cls.space.resume()
        time.sleep(0.3)
        cls.space.restart()
        cls.space.step(3)
        time.sleep(0.3)
        place = PoseStamped()
        place.pose.position.x, place.pose.position.y, place.pose.orientation.w = 4.1, 4.3, 1.0
        for x in (3.7, 4.1):  # while it is at rest
            place.pose.position.x = x
            cls.space.move([EntityPose("fb_2", place)])
        time.sleep(0.3)

    def transforms(self):
        return [t for message in self.moving.messages() for t in message.transforms]

    def test_no_frame_is_sent_twice_with_one_stamp(self):
        seen = set()
        for transform in self.transforms():
            key = (transform.child_frame_id, transform.header.stamp.to_nsec())
            self.assertNotIn(key, seen)
            seen.add(key)
        self.assertGreater(len(seen), 0)

    def test_stamps_rise(self):
        stamps = [m.transforms[0].header.stamp for m in self.moving.messages()]
        self.assertEqual(sorted(stamps), stamps)

    def test_frames_of_one_message_have_one_stamp(self):
        for message in self.moving.messages():
            self.assertEqual(1, len({t.header.stamp.to_nsec() for t in message.transforms}))

    def test_frames_have_one_parent_and_no_leading_slash(self):
        parents = {}
        fixed = [t for message in self.fixed.messages() for t in message.transforms]
        for transform in self.transforms() + fixed:
            child, parent = transform.child_frame_id, transform.header.frame_id
            self.assertFalse(child.startswith("/") or parent.startswith("/"), child)
            self.assertEqual(parent, parents.setdefault(child, parent), child)
        for robot in ("fb_1", "fb_2", "fb_3", "eb", "prey_yellow"):
            self.assertEqual("world", parents[robot + "/base_link"])
        for child in parents:
            root = child
            while root in parents:
                root = parents[root]
            self.assertEqual("world", root, child)

    def test_moving_and_fixed_frames_are_different_ones(self):
        fixed = {t.child_frame_id for message in self.fixed.messages() for t in message.transforms}
        self.assertFalse(fixed & {t.child_frame_id for t in self.transforms()})

    def test_what_is_moved_while_it_stands_still_is_shown_at_once(self):
        shown = [t for t in self.transforms() if t.child_frame_id == "fb_2/base_link"][-3:]
        self.assertEqual([3.7, 4.1], [t.transform.translation.x for t in shown[1:]])
        stamps = [t.header.stamp.to_nsec() for t in shown]
        self.assertEqual([stamps[0] + 2, stamps[0] + 4], stamps[1:], "later than the tick's own, by next to nothing")

    def test_nothing_is_sent_while_paused(self):
        before = len(self.moving.messages())
        time.sleep(0.5)
        self.assertEqual(before, len(self.moving.messages()))


if __name__ == "__main__":
    rospy.init_node("transforms_test")
    rostest.rosrun("swarmanoid_experiments", "transforms", TransformsTest, sys.argv)

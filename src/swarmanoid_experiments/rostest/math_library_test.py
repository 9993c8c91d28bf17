#!/usr/bin/python3
"""The manager that run.launch starts uses the same math library as the program, on any processor and in any shell: with
another library climbing would end differently. A bag contains its name."""

import os
import sys
import unittest

import rosbag
import rospkg
import rospy
import rostest

from space_client import Space, run_without_ros

FOLDER = rospkg.get_ros_home()  # as in space.launch


class MathLibraryTest(unittest.TestCase):
    def test_every_tick_has_the_hash_that_it_has_without_ros(self):
        expected = run_without_ros(self, "climbing", 1)
        Space().step(len(expected))
        with open(os.path.join(FOLDER, "math_library_test.txt")) as file:
            self.assertEqual(expected, file.read().splitlines())
        with rosbag.Bag(os.path.join(FOLDER, "math_library_test.bag")) as bag:
            names = [message.data for _, message, _ in bag.read_messages("/space/math_library")]
        self.assertEqual(1, len(names), names)
        self.assertRegex(names[0], r"^glibc 2\.\d+, any x86-64$")


if __name__ == "__main__":
    rospy.init_node("math_library_test")
    rostest.rosrun("swarmanoid_experiments", "math_library", MathLibraryTest, sys.argv)

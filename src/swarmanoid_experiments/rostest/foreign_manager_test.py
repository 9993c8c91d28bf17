#!/usr/bin/python3
"""A space in a process with processor-specific sine and cosine warns about it at its start and at its end."""

import re
import sys
import unittest

import rospy
import rostest
from rosgraph_msgs.msg import Log

from space_client import Collector, load

WARNING = (r"this process calculates with glibc 2\.\d+, x86-64 with FMA: on another computer, and without ROS, the run may end "
           r"in another state\. Start it with GLIBC_TUNABLES=glibc\.cpu\.hwcaps=-FMA,-FMA4, as setup\.bash and run\.launch do")


def can_fuse():
    with open("/proc/cpuinfo") as file:
        flags = re.search("^flags.*", file.read(), re.M)
    return flags is not None and {"fma", "avx2"} <= set(flags.group().split())


class ForeignManagerTest(unittest.TestCase):
    def test_the_space_warns_and_its_last_line_names_the_library(self):
        log = Collector("/rosout", Log)
        log.wait_for_publisher(count=2)  # this process and the manager
        rospy.set_param("/space", {"experiment": "diffusion", "max_ticks": "3", "real_time_factor": 0.0, "on_end": "stay"})
        self.assertTrue(load("/space", "swarmanoid_ros/SpaceNodelet"))
        end = log.wait_for(lambda line: "diffusion, seed 1: finished after 3 ticks" in line.msg)
        warnings = [line.msg for line in log.messages() if "calculates with" in line.msg]
        if can_fuse():
            self.assertEqual(1, len(warnings), warnings)
            self.assertRegex(warnings[0], "^" + WARNING + "$")
            self.assertRegex(end.msg, r"; calculated with glibc 2\.\d+, x86-64 with FMA$")
        else:
            self.assertEqual([], warnings)
            self.assertNotIn("calculated with", end.msg)


if __name__ == "__main__":
    rospy.init_node("foreign_manager_test")
    rostest.rosrun("swarmanoid_experiments", "foreign_manager", ForeignManagerTest, sys.argv)

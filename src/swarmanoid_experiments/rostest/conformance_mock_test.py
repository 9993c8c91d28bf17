#!/usr/bin/python3
"""The conformance test of the mock drivers of each robot, over topics."""

import subprocess
import sys
import unittest

import rospy
import rostest
from swarmanoid_msgs.msg import LedArray

from space_client import TIMEOUT, Collector
from topic_hosts import ConformanceHosts

FOOTBOT_PLACE = {"walls": {"right": [-1, -0.4, 1, -0.4]},
                 "beacons": {"beacon": {"at": [1, 0, 0.05], "color": "yellow"},
                             "prey": {"at": [0, 0.5, 0.05], "color": "magenta", "can_be_gripped": True}}}
EYEBOT_PLACE = {"start": [0, 0, 1.2], "ceiling": 2.5,
                "beacons": {"beacon": {"at": [0.6, 0, 0], "color": "yellow"},
                            "prey": {"at": [0, 0.6, 0], "color": "magenta"}}}
HANDBOT_PLACE = {"ceiling": 2.5, "hands": {"left": True, "right": False}}
ROBOTS = {"m_footbot": ("footbot", {}), "m_eyebot": ("eyebot", {"laser_height": 1.35, "ceiling": True}),
          "m_handbot": ("handbot", {"ceiling": True, "board": True})}
PLACES = {"m_footbot": FOOTBOT_PLACE, "m_eyebot": EYEBOT_PLACE, "m_handbot": HANDBOT_PLACE}


class ConformanceMockTest(unittest.TestCase):
    def setUp(self):
        self.drivers = []
        for robot, (kind, _) in ROBOTS.items():
            rospy.set_param(f"/{robot}_drivers/world", PLACES[robot])
            self.drivers.append(subprocess.Popen(
                ["rosrun", "swarmanoid_interface", "mock_drivers", f"__name:={robot}_drivers", f"_robot:={robot}",
                 f"_type:={kind}"], start_new_session=True))
        self.leds = Collector("/m_footbot/leds/state", LedArray)
        self.hosts = ConformanceHosts(ROBOTS)

    def tearDown(self):
        self.hosts.end()
        for process in self.drivers:
            process.terminate()
            process.wait(TIMEOUT)

    def test_all_robots_pass(self):
        for robot in ROBOTS:
            verdict = self.hosts.verdict(robot)
            print(robot, verdict)
            self.assertEqual("passed", verdict.get("conformance"), verdict)
            # nobody looks at a mock robot's LEDs
            self.assertEqual({"m_footbot": "footbot_leds", "m_eyebot": "eyebot_leds", "m_handbot": "none"}[robot],
                             verdict["unchecked_devices"], verdict)
        # but their driver was told: red ahead, blue to the left, green behind
        shown = self.leds.wait_for(lambda message: message.colors[0].r == 1.0)
        self.assertEqual((1.0, 1.0), (shown.colors[3].b, shown.colors[6].g))


if __name__ == "__main__":
    rospy.init_node("conformance_mock_test")
    rostest.rosrun("swarmanoid_experiments", "conformance_mock", ConformanceMockTest, sys.argv)

#!/usr/bin/python3
"""The conformance test of the mock drivers of each robot, over topics; the hosts' frames are recorded, and replayed."""

import os
import subprocess
import sys
import tempfile
import unittest

import rosbag
import rospy
import rostest
from swarmanoid_msgs.msg import CommandFrame, ControllerStart, LedArray, SensorFrame

from space_client import TIMEOUT, Collector
from topic_hosts import ConformanceHosts

FOOTBOT_PLACE = {"walls": {"right": [-1, -0.4, 1, -0.4]},
                 "tags": {"below": {"at": [0, 0], "id": 7, "data": 1234}},
                 "beacons": {"beacon": {"at": [1, 0, 0.05], "color": "yellow"},
                             "prey": {"at": [0, 0.5, 0.05], "color": "magenta", "can_be_gripped": True},
                             "partner": {"at": [-0.6, 0.8, 0], "color": "black", "answers": True}}}
EYEBOT_PLACE = {"start": [0, 0, 1.2], "ceiling": 2.5,
                "beacons": {"beacon": {"at": [0.6, 0, 0], "color": "yellow"},
                            "prey": {"at": [0, 0.6, 0], "color": "magenta"},
                            "partner": {"at": [-0.6, 0.8, 0.2], "color": "black", "answers": True}}}
HANDBOT_PLACE = {"ceiling": 2.5, "hands": {"left": True, "right": False}, "walls": {"right": [-1, -0.3, 1, -0.3]},
                 "beacons": {"beacon": {"at": [0.8, 0, 0.05], "color": "yellow"},
                             "prey": {"at": [0.773, -0.207, 0.05], "color": "magenta"},
                             "partner": {"at": [-0.6, 0.8, 0], "color": "black", "answers": True}}}
TALKING = {"partner": "partner", "partner_distance": 1, "partner_bearing": 126.87}
ROBOTS = {"m_footbot": ("footbot", dict(TALKING, tag_id=7, tag_data=1234)),
          "m_eyebot": ("eyebot", dict(TALKING, partner_height=-1, laser_height=1.35, ceiling=True)),
          "m_handbot": ("handbot", dict(TALKING, ceiling=True, board=True, beacon_distance=0.8, prey_distance=0.8,
                                        prey_bearing=-15, wall_distance=0.3))}
OTHERS = ["range_and_bearing", "range_and_bearing_received", "wifi", "wifi_received", "bluetooth", "bluetooth_received",
          "rfid_reader", "rfid_writer"]  # devices that any robot may have
FRAMES = {"start": ControllerStart, "sensors": SensorFrame, "commands": CommandFrame}
PLACES = {"m_footbot": FOOTBOT_PLACE, "m_eyebot": EYEBOT_PLACE, "m_handbot": HANDBOT_PLACE}


class ConformanceMockTest(unittest.TestCase):
    def setUp(self):
        # hosts wait for their drivers, so the recorders are connected before the first step
        self.frames = {f"/{robot}/controller/{what}": Collector(f"/{robot}/controller/{what}", kind)
                       for robot in ROBOTS for what, kind in FRAMES.items()}
        self.hosts = ConformanceHosts(ROBOTS)
        for collector in self.frames.values():
            collector.wait_for_publisher()
        self.drivers = []
        for robot, (kind, _) in ROBOTS.items():
            rospy.set_param(f"/{robot}_drivers/world", PLACES[robot])
            self.drivers.append(subprocess.Popen(
                ["rosrun", "swarmanoid_hosts", "mock_drivers", f"__name:={robot}_drivers", f"_robot:={robot}",
                 f"_type:={kind}", f"_devices:={' '.join(OTHERS)}"], start_new_session=True))
        self.leds = Collector("/m_footbot/leds/state", LedArray)

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
            # no observer judges a mock robot's LEDs
            self.assertEqual({"m_footbot": "footbot_leds", "m_eyebot": "eyebot_leds", "m_handbot": "none"}[robot],
                             verdict["unchecked_devices"], verdict)
        # but their driver received commands: red ahead, blue to the left, green behind
        shown = self.leds.wait_for(lambda message: message.colors[0].r == 1.0)
        self.assertEqual((1.0, 1.0), (shown.colors[3].b, shown.colors[6].g))
        self.replay()

    def replay(self):
        """Expects that the controllers repeat their commands."""
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, "robots.bag")
            with rosbag.Bag(file, "w") as bag:
                for topic, collector in self.frames.items():
                    for message in collector.messages():
                        bag.write(topic, message)
            done = subprocess.run(["rosrun", "swarmanoid_recording", "replay", file], capture_output=True, text=True)
        print(done.stdout, done.stderr)
        self.assertEqual(0, done.returncode)
        for robot in ROBOTS:
            self.assertRegex(done.stdout, rf"{robot}: all \d{{3,}} ticks are equal")


if __name__ == "__main__":
    rospy.init_node("conformance_mock_test")
    rostest.rosrun("swarmanoid_experiments", "conformance_mock", ConformanceMockTest, sys.argv)

#!/usr/bin/python3
"""The conformance test of simulated robots over standard topics, in real time; the hosts' frames are recorded, and
replayed."""

import os
import subprocess
import sys
import tempfile
import unittest

import rosbag
import rospy
import rostest
from swarmanoid_msgs.msg import CommandFrame, ControllerStart, SensorFrame

from participants import set_source
from space_client import Collector, Space
from topic_hosts import ConformanceHosts

# as in conformance.xml
TALKING = {robot: {"partner": robot + "_observer", "partner_distance": distance, "partner_bearing": bearing,
                   "partner_height": height}
           for robot, distance, bearing, height in (("fb", 1.2, 90, 0), ("eb", 0.6, 180, -1.29), ("hb", 0.7, 150, -0.075))}
ROBOTS = {"fb": ("footbot", dict(TALKING["fb"], tag_id=7, tag_data=1234)),
          "eb": ("eyebot", dict(TALKING["eb"], laser_height=1.35, ceiling=True)),
          "hb": ("handbot", dict(TALKING["hb"], ceiling=True, board=True, beacon_distance=0.8, prey_distance=0.8,
                                 prey_bearing=-15, wall_distance=0.3))}
FRAMES = {"start": ControllerStart, "sensors": SensorFrame, "commands": CommandFrame}


class ConformanceTopicsTest(unittest.TestCase):
    def test_all_robots_pass(self):
        # hosts wait for their robots, so the recorders are connected before the first step
        frames = {f"/{robot}/controller/{what}": Collector(f"/{robot}/controller/{what}", kind)
                  for robot in ROBOTS for what, kind in FRAMES.items()}
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
        self.replay(frames)

    def replay(self, frames):
        """Expects that the controllers repeat their commands."""
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, "robots.bag")
            with rosbag.Bag(file, "w") as bag:
                for topic, collector in frames.items():
                    for message in collector.messages():
                        bag.write(topic, message)
            done = subprocess.run(["rosrun", "swarmanoid_recording", "replay", file], capture_output=True, text=True)
        print(done.stdout, done.stderr)
        self.assertEqual(0, done.returncode)
        for robot in ROBOTS:
            self.assertRegex(done.stdout, rf"{robot}: all \d{{3,}} ticks are equal")


if __name__ == "__main__":
    rospy.init_node("conformance_topics_test")
    rostest.rosrun("swarmanoid_experiments", "conformance_topics", ConformanceTopicsTest, sys.argv)

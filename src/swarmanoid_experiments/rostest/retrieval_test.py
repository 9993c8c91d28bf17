#!/usr/bin/python3
"""The launched experiment ends with the prey in the nest, exactly as without ROS, and the bag contains every tick."""

import json
import os
import subprocess
import sys
import unittest

import rosbag
import rospkg
import rospy
import rostest
from swarmanoid_msgs.msg import RunResult

from space_client import Collector, Space, run_without_ros

BAG = os.path.join(rospkg.get_ros_home(), "retrieval_test.bag")  # as in space.launch


class RetrievalTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        space = Space()
        results = Collector("/space/result", RunResult)
        space.resume()
        cls.result = results.wait_for(lambda r: True, 50.0)

    def test_the_prey_is_in_the_nest(self):
        self.assertIsNotNone(self.result, "the run does not end")
        self.assertTrue(self.result.finished)
        self.assertTrue(self.result.judged)
        self.assertTrue(self.result.success)
        self.assertEqual([], self.result.failed_robots)

    def test_it_is_the_same_run_as_without_ros(self):
        command = ["swarmanoid", "run", "object_retrieval", "--seed", "1", "--quiet"]
        summary = json.loads(subprocess.run(command, stdout=subprocess.PIPE, check=True).stdout)
        self.assertEqual(summary["ticks"], self.result.ticks)
        self.assertEqual(int(summary["state_hash"], 16), self.result.state_hash)

    def test_the_bag_holds_every_tick(self):
        with rosbag.Bag(BAG) as bag:
            counts = {topic: info.message_count for topic, info in bag.get_type_and_topic_info().topics.items()}
            ticks = [m.tick for _, m, _ in bag.read_messages("/space/world_state")]
            stamps = [(m.header.stamp, t) for _, m, t in bag.read_messages("/space/world_state")]
            hashes = [f"{m.tick} {m.state_hash:016x}" for _, m, _ in bag.read_messages("/space/world_state")]
            moving = [m.transforms[0].header.stamp for _, m, _ in bag.read_messages("/tf")]
        states = self.result.ticks + 1
        self.assertEqual(list(range(states)), ticks)
        self.assertEqual(run_without_ros(self, "object_retrieval", 1), hashes)
        self.assertEqual([stamp for stamp, _ in stamps], moving)
        for topic in ("/clock", "/tf", "/space/markers"):
            self.assertEqual(states, counts[topic], topic)
        for topic in ("/tf_static", "/space/markers_static", "/space/experiment"):
            self.assertEqual(1, counts[topic], topic)
        for stamp, time in stamps:
            self.assertEqual(stamp, time, "bags are in simulated time")


if __name__ == "__main__":
    rospy.init_node("retrieval_test")
    rostest.rosrun("swarmanoid_experiments", "retrieval", RetrievalTest, sys.argv)

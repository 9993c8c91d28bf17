#!/usr/bin/python3
"""With topics for all robots, spawned robots get topics during a run, paused or not, and deleted robots lose them."""

import sys
import time
import unittest

import rosgraph
import rospy
import rostest
from geometry_msgs.msg import PoseStamped, Twist
from swarmanoid_msgs.msg import EntitySpecification, ProximityArray, WorldState

from participants import set_source
from space_client import TIMEOUT, Collector, Space

AT_START = {"fb_1", "fb_2", "fb_3", "eb"}


def footbot(name):
    pose = PoseStamped()
    pose.pose.position.x = pose.pose.position.y = 4.5
    pose.pose.orientation.w = 1.0
    return EntitySpecification(name=name, type="footbot", engines=["ground"], controller="fc", pose=pose)


class SpawnedTopicsTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.space = Space()

    def setUp(self):
        self.space.restart()
        self.assert_robots_with_topics(AT_START)

    def tearDown(self):
        self.space.restart()

    @staticmethod
    def robots_with_topics():
        published, subscribed, _ = rosgraph.Master("/spawned_topics_test").getSystemState()
        return {topic.split("/")[1] for topic, nodes in published + subscribed if "/swarmanoid" in nodes
                and topic.startswith(("/fb_", "/eb/"))}

    def assert_robots_with_topics(self, robots):
        until = time.monotonic() + TIMEOUT
        while self.robots_with_topics() != robots and time.monotonic() < until:
            time.sleep(0.05)
        self.assertEqual(robots, self.robots_with_topics())

    def test_a_spawned_robot_has_topics_until_it_is_deleted(self):
        self.assertTrue(self.space.spawn([footbot("fb_9")]).success)
        self.assert_robots_with_topics(AT_START | {"fb_9"})
        readings = Collector("/fb_9/proximity", ProximityArray)
        readings.wait_for_publisher()
        state = self.space.step(1).stamp
        self.space.step(1)
        message = readings.wait_for(lambda m: m.header.stamp == state)
        self.assertEqual("fb_9/base_link", message.header.frame_id)
        self.assertTrue(self.space.delete(["fb_9"]).success)
        self.assert_robots_with_topics(AT_START)
        self.assertTrue(self.space.spawn([footbot("fb_9")]).success)
        self.assert_robots_with_topics(AT_START | {"fb_9"})

    def test_a_spawned_robot_can_be_commanded_over_topics(self):
        worlds = Collector("/space/world_state", WorldState)
        worlds.wait_for_publisher()
        self.assertTrue(self.space.spawn([footbot("fb_9")]).success)
        self.assert_robots_with_topics(AT_START | {"fb_9"})
        answer = set_source(["fb_9"], "topics")
        self.assertTrue(answer.success, answer.message)
        velocity = rospy.Publisher("/fb_9/cmd_vel", Twist, queue_size=1)
        until = time.monotonic() + TIMEOUT
        while velocity.get_num_connections() == 0 and time.monotonic() < until:
            time.sleep(0.01)
        twist = Twist()
        twist.angular.z = 0.5
        velocity.publish(twist)
        time.sleep(0.3)
        tick = self.space.step(3).tick
        world = worlds.wait_for(lambda w: w.tick == tick)
        self.assertGreater(world.poses[world.names.index("fb_9")].orientation.z, 0.01)

    def test_a_reset_takes_away_what_was_spawned_and_brings_back_what_was_deleted(self):
        self.assertTrue(self.space.spawn([footbot("fb_8"), footbot_elsewhere("fb_9")]).success)
        self.assertTrue(self.space.delete(["fb_2", "eb"]).success)
        self.assert_robots_with_topics({"fb_1", "fb_3", "fb_8", "fb_9"})
        self.space.restart()
        self.assert_robots_with_topics(AT_START)

    def test_many_come_and_go_while_it_runs(self):
        self.space.resume()
        for _ in range(5):
            self.assertTrue(self.space.spawn([footbot("fb_9")]).success)
            self.assertTrue(self.space.delete(["fb_9"]).success)
        self.space.pause()
        self.assert_robots_with_topics(AT_START)


def footbot_elsewhere(name):
    result = footbot(name)
    result.pose.pose.position.y = 4.0
    return result


if __name__ == "__main__":
    rospy.init_node("spawned_topics_test", anonymous=True)
    rostest.rosrun("swarmanoid_experiments", "spawned_topics", SpawnedTopicsTest, sys.argv)

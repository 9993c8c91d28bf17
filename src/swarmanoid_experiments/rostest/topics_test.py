#!/usr/bin/python3
"""Robots commanded over standard topics, and by controllers in Python: those of the example package, once in lockstep and
once free-running."""

import math
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time
import unittest

import rospkg
import rospy
import rostest
from geometry_msgs.msg import Twist
from rosgraph_msgs.msg import Log
from std_msgs.msg import ColorRGBA
from swarmanoid_msgs.msg import Event, LedArray, WheelsCommand, WorldState

from participants import set_source
from space_client import TIMEOUT, Collector, Space, run_without_ros

REPOSITORY = pathlib.Path(rospkg.RosPack().get_path("swarmanoid_experiments")).parents[1]
EXPERIMENT = REPOSITORY / "src/swarmanoid_experiments/rostest/topics.xml"
SCRIPTS = REPOSITORY / "examples/example_python_controller/scripts"
HASHES = os.path.join(rospkg.get_ros_home(), "topics_test.txt")  # as in space.launch
TICK = 0.1  # [s]


class Script:
    def __init__(self, name, *arguments):
        self._process = subprocess.Popen([str(SCRIPTS / name), *arguments])

    def end(self):
        self._process.send_signal(signal.SIGINT)
        return self._process.wait(TIMEOUT)


def publisher(topic, kind):
    result = rospy.Publisher(topic, kind, queue_size=10)
    until = time.monotonic() + TIMEOUT
    while result.get_num_connections() == 0 and time.monotonic() < until:
        time.sleep(0.01)
    return result


class TopicsTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.space = Space()
        cls.worlds = Collector("/space/world_state", WorldState)
        cls.events = Collector("/space/events", Event)
        cls.logs = Collector("/rosout", Log)
        for collector in (cls.worlds, cls.events, cls.logs):
            collector.wait_for_publisher()

    def setUp(self):
        self.space.restart()
        for collector in (self.worlds, self.events, self.logs):
            collector.clear()

    def step(self, ticks=1):
        """@return position and heading of fb_2 afterwards"""
        tick = self.space.step(ticks).tick
        world = self.worlds.wait_for(lambda message: message.tick == tick)
        pose = world.poses[world.names.index("fb_2")]
        return pose.position.x, pose.position.y, 2 * math.atan2(pose.orientation.z, pose.orientation.w)

    def event(self, entity, text):
        return self.events.wait_for(lambda event: event.entity == entity and event.text == text)

    def test_commands_move_the_robot_and_silence_stops_it(self):
        wheels = publisher("/fb_2/wheels/command", WheelsCommand)
        before = self.step(5)
        self.assertEqual((2.0, 2.0, 0.0), before, "nobody has commanded it yet")
        wheels.publish(left=2.0, right=2.0)
        time.sleep(0.3)
        x, y, _ = self.step(1)
        self.assertAlmostEqual(2.0 + 2.0 * 0.029 * TICK, x, 9, "from the next tick on")
        self.assertEqual(2.0, y)
        event = self.event("fb_2", "commands come over topics")
        self.assertEqual(6, event.tick)
        # the time-out is half a second: commands of tick 5 are valid until tick 9
        x, _, _ = self.step(10)
        self.assertAlmostEqual(2.0 + 5 * 2.0 * 0.029 * TICK, x, 9)
        self.assertEqual(11, self.event("fb_2", "no more commands over topics, the robot stops").tick)

    def test_a_twist_and_lights(self):
        velocity = publisher("/fb_2/cmd_vel", Twist)
        leds = publisher("/fb_2/leds/command", LedArray)
        shown = Collector("/fb_2/leds/state", LedArray)
        twist = Twist()
        twist.angular.z = 0.5
        velocity.publish(twist)
        leds.publish(colors=[ColorRGBA(1, 0, 0, 1)] + 11 * [ColorRGBA(0, 0, 0, 0)])
        time.sleep(0.3)
        x, y, heading = self.step(2)
        self.assertAlmostEqual(0.5 * 2 * TICK, heading, 9)
        self.assertAlmostEqual(2.0, x, 6)
        self.assertAlmostEqual(2.0, y, 6)
        self.assertIsNotNone(shown.wait_for(lambda message: message.colors[0].r == 1 and message.colors[1].a == 0))

    def test_bad_commands_are_refused_with_the_reason(self):
        velocity = publisher("/fb_2/cmd_vel", Twist)
        twist = Twist()
        twist.linear.y = 0.5
        velocity.publish(twist)
        warning = self.logs.wait_for(lambda log: log.msg.startswith("fb_2/cmd_vel"))
        self.assertEqual("fb_2/cmd_vel: found linear.y 0.500000, allowed: 0, this robot cannot do it", warning.msg)
        self.assertEqual((2.0, 2.0, 0.0), self.step(3))

    def test_commands_for_others_are_refused_with_one_warning(self):
        wheels = publisher("/fb_1/wheels/command", WheelsCommand)
        for _ in range(5):
            wheels.publish(left=5.0, right=5.0)
        refused = "fb_1/wheels/command is refused: 'fb_1' is not commanded over topics; its command source says by whom"
        self.assertIsNotNone(self.logs.wait_for(lambda log: log.msg == refused))
        time.sleep(0.2)
        self.assertEqual(1, sum(log.msg == refused for log in self.logs.messages()))

    def test_a_robot_with_device_topics_may_change_to_that_source(self):
        self.assertTrue(set_source(["fb_1"], "topics").success)
        self.assertTrue(set_source(["fb_1"], "controller").success)

    def test_python_in_lockstep_has_the_bits_of_the_same_controller_in_cpp(self):
        self.assertTrue(set_source(["fb_2"], "none").success)
        self.assertTrue(set_source(["fb_1"], "remote").success)
        script = Script("diffusion_in_lockstep.py", "fb_1")
        start = time.monotonic()
        self.assertTrue(self.space.step(400).success)
        print(f"one process in Python: {400 / (time.monotonic() - start):.0f} ticks/s")
        with open(HASHES) as file:
            seen = file.read().splitlines()
        self.assertEqual(0, script.end())
        with tempfile.NamedTemporaryFile("w", suffix=".xml") as file:
            file.write(EXPERIMENT.read_text().replace('source="topics" timeout="0.5"', 'source="none"'))
            file.flush()
            self.assertEqual(run_without_ros(self, file.name, 1), seen)

    def test_python_free_running(self):
        script = Script("diffusion_free_running.py", "fb_2")
        self.events.clear()
        self.step()
        until = time.monotonic() + TIMEOUT
        while not self.event_now("fb_2", "commands come over topics") and time.monotonic() < until:
            self.step()
            time.sleep(0.05)
        for _ in range(150):
            x, y, heading = self.step()
            time.sleep(0.01)
        self.assertGreater(math.hypot(x - 2.0, y - 2.0), 0.1)
        self.assertNotAlmostEqual(0.0, heading, 1, "it has met the wall and turned")
        self.assertEqual(0, script.end())

    def event_now(self, entity, text):
        return any(event.entity == entity and event.text == text for event in self.events.messages())


if __name__ == "__main__":
    rospy.init_node("topics_test")
    rostest.rosrun("swarmanoid_experiments", "topics", TopicsTest, sys.argv)

#!/usr/bin/python3
"""A robot over topics stops safely, each type of robot: when its controller throws, when its sensors are lost, and when
its process is asked to end."""

import signal
import sys
import time
import xmlrpc.client

import rosgraph
import rospy
import rostest
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from swarmanoid_msgs.msg import (CommandFrame, GripperCommand, HandsCommand, LaserCommand, RopeCommand, TurretCommand,
                                 WheelsCommand)

from robot_processes import RATE, Arrivals, Drivers, Host, RobotTestCase, configuration, wait_until

SENSOR_TIMEOUT = 0.5  # [s]
NOISE = 1.5  # [s] that this machine may be late


class Kind:
    """One type of robot: its commanded direction, its speed over time (misbehaving_controller.cpp)."""

    def __init__(self, topic, message, speed_of, speed_at):
        self.topic = topic
        self.message = message
        self.speed_of = speed_of
        self.speed_at = speed_at

    def moves(self, message):
        return self.speed_of(message) > 0.0


KINDS = {"footbot": Kind("wheels/command", WheelsCommand, lambda m: m.left, lambda t: 1.0 + t),
         "eyebot": Kind("cmd_vel", Twist, lambda m: m.linear.x, lambda t: 0.1 + 0.01 * t),
         "handbot": Kind("rope/command", RopeCommand, lambda m: m.winding_speed, lambda t: 0.1 + 0.01 * t)}
# further conditions at the end: topic, message, condition
HELD = {"footbot": (("gripper/command", GripperCommand, lambda m: m.closed),
                    ("turret/command", TurretCommand, lambda m: m.mode == TurretCommand.SPEED and m.speed == 0.0),
                    ("wheels/command", WheelsCommand, lambda m: m.left == m.right == 0.0)),
        "eyebot": (("laser/command", LaserCommand, lambda m: not m.on),
                   ("cmd_vel", Twist, lambda m: m.linear.x == m.linear.z == 0.0)),
        "handbot": (("hands/command", HandsCommand, lambda m: m.left),
                    ("rope/command", RopeCommand, lambda m: m.shot and m.winding_speed == 0.0))}


def rosnode_kill(host):
    address = rosgraph.Master("/robot_safe_stop_test").lookupNode("/" + host.name)
    xmlrpc.client.ServerProxy(address).shutdown("/robot_safe_stop_test", "as rosnode kill does it")


class RobotSafeStopTest(RobotTestCase):
    def start(self, kind, name, **parameters):
        """@return drivers, host, and commands once it moves"""
        self.end()
        robot = f"{kind}_{name}"
        commands = Arrivals(f"/{robot}/{KINDS[kind].topic}", KINDS[kind].message)
        self.others = [(Arrivals(f"/{robot}/{topic}", message), is_held) for topic, message, is_held in HELD[kind]]
        self.odometry = Arrivals(f"/{robot}/ground_truth/odom", Odometry)
        self.processes.append(Drivers(robot, kind))
        self.processes.append(Host(robot, configuration(kind, parameters=parameters)))
        self.assertIsNotNone(commands.wait_for(KINDS[kind].moves), self.processes[-1].output())
        return (*self.processes[-2:], commands)

    def assert_held(self):
        for arrivals, is_held in self.others:
            self.assertTrue(is_held(arrivals.messages()[-1]), arrivals.messages()[-1])

    def test_exception(self):
        for kind, its in KINDS.items():
            with self.subTest(kind):
                frames = Arrivals(f"/{kind}_throws/controller/commands", CommandFrame)
                _, host, commands = self.start(kind, "throws", throw_at=2.0)
                self.assertEqual(3, host.wait(), "a controller failed")
                self.assertIn("the controller failed: told to", host.output())
                failing = frames.messages()[-1]
                self.assertEqual(2, failing.data[0], "the frame says that the controller failed")
                before = frames.messages()[-2]
                messages = commands.messages()
                last = max(i for i, message in enumerate(messages) if its.moves(message))
                self.assertAlmostEqual(its.speed_at(before.tick / RATE), its.speed_of(messages[last]), places=9,
                                       msg="the stop comes in the period that throws, in place of a command")
                self.assertGreaterEqual(len(messages) - 1 - last, 3, "and is said again")
                self.assert_held()

    def test_lost_sensors(self):
        for kind, its in KINDS.items():
            with self.subTest(kind):
                drivers, host, commands = self.start(kind, "loses")
                time.sleep(0.3)
                lost = time.monotonic()
                drivers.send_to_node(signal.SIGSTOP)
                self.assertTrue(wait_until(lambda: not its.moves(commands.messages()[-1])), "it never stops")
                stopped = max(when for when, message in commands.all() if its.moves(message))
                self.assertGreater(stopped - lost, SENSOR_TIMEOUT - 2.0 / RATE, "it stops before the time is over")
                self.assertLess(stopped - lost, SENSOR_TIMEOUT + 1.0 / RATE + NOISE)
                self.assertTrue(host.wait_for_text("stopped safely: "), host.output())
                self.assertIn(" is silent for ", host.output())
                count = len(commands.all())
                if kind == "eyebot":
                    self.assertIsNotNone(commands.wait_for(lambda m: m.linear.z == -0.4), "it does not come down")
                drivers.send_to_node(signal.SIGCONT)
                self.assertTrue(wait_until(lambda: any(map(its.moves, commands.messages()[count:]))), "it stays stopped")

    def test_end(self):
        for kind, its in KINDS.items():
            with self.subTest(kind):
                _, host, commands = self.start(kind, "ends")
                host.send(signal.SIGINT)
                self.assertEqual(0, host.wait(), host.output())
                self.assertFalse(its.moves(commands.messages()[-1]))
                self.assert_held()
                if kind == "eyebot":
                    heights = [message.linear.z for message in commands.messages()]
                    self.assertIn(-0.4, heights, "it comes down")
                    self.assertEqual(0.0, heights[-1])
                    self.assertLess(self.odometry.messages()[-1].pose.pose.position.z, 1.5 - 0.3)

    def test_end_by_other_means(self):
        its = KINDS["footbot"]
        for name, end in (("sigterm", lambda host: host.send(signal.SIGTERM)), ("rosnode", rosnode_kill)):
            with self.subTest(name):
                _, host, commands = self.start("footbot", name)
                end(host)
                self.assertEqual(0, host.wait(), host.output())
                self.assertFalse(its.moves(commands.messages()[-1]))
                self.assert_held()

    def test_drivers_stop_when_the_host_is_gone(self):
        """After a signal that cannot be caught the drivers stop the robot."""
        _, host, _ = self.start("footbot", "killed")
        self.assertIsNotNone(self.odometry.wait_for(lambda m: m.twist.twist.linear.x > 0.02))
        host.send(signal.SIGKILL)
        killed = time.monotonic()
        self.assertTrue(wait_until(lambda: abs(self.odometry.messages()[-1].twist.twist.linear.x) < 1e-3))
        self.assertLess(time.monotonic() - killed, 0.5 + NOISE)


if __name__ == "__main__":
    rospy.init_node("robot_safe_stop_test")
    rostest.rosrun("swarmanoid_experiments", "robot_safe_stop", RobotSafeStopTest, sys.argv)

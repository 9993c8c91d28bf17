#!/usr/bin/python3
"""A robot's host over topics: it starts only once all devices are present, reports overruns, does not touch devices
that its configuration does not list, publishes its controller's input and output, and reports mistakes in a
configuration."""

import sys

import rosgraph
import rospy
import rostest
from diagnostic_msgs.msg import DiagnosticArray
from nav_msgs.msg import Odometry
from swarmanoid_msgs.msg import CommandFrame, ControllerStart, SensorFrame, WheelsCommand

from robot_processes import RATE, Arrivals, Drivers, Host, RobotTestCase, configuration


class RobotHostTest(RobotTestCase):
    def start(self, robot, settings, **parameters):
        self.end()
        self.processes.append(Drivers(robot, "footbot"))
        self.processes.append(Host(robot, settings, **parameters))
        return self.processes[-1]

    def test_missing_devices_are_named(self):
        for name, missing, text in (
                ("blind", {"sensors": ["footbot_proximity", "distances"]}, "distances (nobody publishes distance)"),
                ("lame", {"actuators": ["footbot_wheels", "footbot_beacon"]},
                 "footbot_beacon (nobody subscribes to footbot_beacon/command)")):
            with self.subTest(name):
                self.end()
                wheels = Arrivals(f"/{name}/wheels/command", WheelsCommand)
                self.processes.append(Drivers(name, "footbot"))
                self.assertIsNotNone(Arrivals(f"/{name}/ground_truth/odom", Odometry).wait_for(lambda _: True))
                host = Host(name, configuration("footbot", start_timeout=3.0, **missing))
                self.processes.append(host)
                self.assertEqual(4, host.wait(), host.output())
                self.assertIn(f"{name}: missing: {text}", host.output())
                self.assertNotIn("running", host.output())
                self.assertEqual([], wheels.all())

    def test_launch_file_refuses_bad_arguments(self):
        for name, value, text in (
                ("clocktick", "fast", "framework.clocktick: clocktick: found 'fast', allowed: a number from 0.001 to 1000000"),
                ("watchdog", "-1", "arena.robot.controller.timeout: timeout: found '-1', allowed: a number"),
                ("set", "arena.robot.colour=red", "found tag 'colour', allowed: ")):
            with self.subTest(name):
                self.processes.append(Drivers("bad", "footbot", **{name: value}))
                self.assertEqual(1, self.processes[-1].wait())
                self.assertIn(text, self.processes[-1].output())

    def test_a_device_is_added_by_set(self):
        self.processes.append(Drivers("more", "footbot", set="controllers.devices.sensors.floor_color="))
        self.assertIsNotNone(Arrivals("/more/floor_color", rospy.AnyMsg).wait_for(lambda _: True), self.processes[-1].output())

    def test_it_waits_for_drivers(self):
        rospy.set_param("/use_sim_time", True)  # as an earlier simulation leaves it: without a clock, time stands still
        self.processes.append(Host("early", configuration("footbot")))
        self.assertTrue(self.processes[-1].wait_for_text("waiting for footbot_proximity"), self.processes[-1].output())
        self.processes.append(Drivers("early", "footbot"))
        self.assertTrue(self.processes[0].wait_for_text("early: running"), self.processes[0].output())

    def test_overruns_are_reported_and_do_not_pile_up(self):
        frames = Arrivals("/slow/controller/sensors", SensorFrame)
        diagnostics = Arrivals("/diagnostics", DiagnosticArray)
        host = self.start("slow", configuration("footbot", parameters={"sleep_at": 2.0, "sleep": 0.6}))

        def overruns(array):
            return [value.value for status in array.status if status.name == "slow: controller"
                    for value in status.values if value.key == "periods left out" and int(value.value) >= 11]

        found = diagnostics.wait_for(overruns)
        self.assertIsNotNone(found, host.output())
        self.assertTrue(host.wait_for_text("slow: overrun: "), host.output())
        ticks = [frame.tick for frame in frames.messages()]
        jumps = [(b - a, frame) for a, b, frame in zip(ticks, ticks[1:], frames.messages()[1:]) if b - a >= 11]
        self.assertEqual(1, len(jumps), "0.6 s are 12 periods")
        jump, frame = jumps[0]
        self.assertAlmostEqual(jump / RATE, frame.clocktick.to_sec(), places=6)

    def test_what_is_not_listed_is_left_alone(self):
        host = self.start("modest", configuration("footbot", actuators=["footbot_wheels"],
                                                  topics={"footbot_wheels": "cmd_vel"}))
        self.assertTrue(host.wait_for_text("modest: running"), host.output())
        publishers, subscribers, _ = rosgraph.Master("/robot_host_test").getSystemState()
        mine = {name for name, nodes in publishers if "/modest_controller" in nodes}
        self.assertEqual({"/modest/cmd_vel", "/modest/controller/start", "/modest/controller/sensors",
                          "/modest/controller/commands", "/diagnostics", "/rosout"}, mine)
        self.assertEqual({"/modest/proximity"},
                         {name for name, nodes in subscribers if "/modest_controller" in nodes and "modest" in name})

    def test_what_the_controller_saw_and_did_can_be_recorded(self):
        start = Arrivals("/seen/controller/start", ControllerStart)
        sensors = Arrivals("/seen/controller/sensors", SensorFrame)
        commands = Arrivals("/seen/controller/commands", CommandFrame)
        self.start("seen", configuration("footbot", seed=7, parameters={"sleep": 0.1}))
        self.assertIsNotNone(commands.wait_for(lambda frame: frame.tick > 20))
        robot = start.messages()[0].robot
        self.assertEqual(("seen", "footbot", "misbehaving"), (robot.name, robot.type, robot.label))
        self.assertEqual([("sleep", "0.1")],
                         [(parameter.name, f"{float(parameter.value):g}") for parameter in robot.parameters])
        self.assertEqual(["footbot_proximity"], [device.type for device in robot.sensors])
        self.assertEqual(7, start.messages()[0].seed)
        first = sensors.messages()[-5]
        self.assertAlmostEqual(1.0 + first.tick / RATE, first.stamp.to_sec(), places=6)
        self.assertEqual(1 + 4 + 24 * 4, len(first.data), "one byte, and the ring as a block")
        answers = [frame for frame in commands.messages() if frame.tick == first.tick]
        self.assertEqual(1, len(answers))
        self.assertEqual(1, answers[0].data[0])

    def test_bad_input_is_refused(self):
        for name, settings, parameters, text in (
                ("a", configuration("footbot", rate=0), {}, "rate: found '0', allowed: a number from 0.1 to 1000"),
                ("b", configuration("footbot", sensors=["footbot_proximty"]), {}, "did you mean 'footbot_proximity'?"),
                ("c", configuration("footbot", sensor_time_out=1), {}, "'sensor_time_out' is not known in <configuration>"),
                ("d", configuration("footbot", parameters={"speed": 1}), {},
                 "/d_controller/configuration/parameters/speed: 'speed' is not known in <parameters>"),
                ("e", configuration("footbot"), {"provider": "topic"}, "provider: found 'topic', allowed: lockstep, topics"),
                ("g", configuration("footbot"), {"parameters": {"throw_at": 1}},
                 "/g_controller/parameters: found values, allowed: none with provider:=topics"),
                ("h", configuration("footbot"), {"provider": "lockstep"},
                 "/h_controller/configuration: found values, allowed: none with provider:=lockstep"),
                ("i", configuration("footbot"), {"timeout": "2s"},
                 "/i_controller: ~timeout: found '2s', allowed: a number from 0 to 3600"),
                ("j", configuration("footbot"), {"use_topic": True}, "found the parameter 'use_topic', allowed: "),
                ("k", configuration("footbot"), {"use_topic": True}, "did you mean 'use_topics'?"),
                ("f", configuration("footbot"), {"robots": "f g"}, "found 'f g', allowed with provider:=topics: the name "
                                                                  "of one robot")):
            with self.subTest(text):
                host = Host(name, settings, **parameters)
                self.processes.append(host)
                self.assertEqual(2, host.wait(), host.output())
                self.assertIn(text, host.output())


if __name__ == "__main__":
    rospy.init_node("robot_host_test")
    rostest.rosrun("swarmanoid_experiments", "robot_host", RobotHostTest, sys.argv)

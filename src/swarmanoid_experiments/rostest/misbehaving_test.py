#!/usr/bin/python3
"""Misbehaving users' code under roslaunch: it is named, data are saved as far as possible, services answer."""

import os
import pathlib
import re
import signal
import subprocess
import sys
import threading
import time
import unittest

import rosbag

from roslaunch_process import LAUNCH_FOLDER, TIMEOUT, RoslaunchTest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "test"))
from misbehaving_world import ENGINE, NAME, PLACES, SENSOR, VISUALISATION, world, world_with

LIMIT = 60.0  # [s]


class MisbehavingTest(RoslaunchTest):
    launch_file = LAUNCH_FOLDER / "run.launch"

    def start(self, *command):
        process = super().start(*command)
        self.port = process.args[-1]
        self.addCleanup(process.stdout.close)
        self.addCleanup(process.kill)
        return process

    def begin(self, phase, action, *arguments, who=None, by=("swarmanoid", "launch"), **more):
        """roslaunch of the world, which records a bag. @param who: plugin other than a controller. @param by: command that starts it"""
        more["maxclock"] = 10**6
        return self.begin_with(world(phase, action, **more) if who is None else world_with(who, phase, action, **more),
                               *arguments, by=by)

    def begin_with(self, text, *arguments, by=("swarmanoid", "launch")):
        self.path = pathlib.Path(self.folder.name)
        experiment = self.path / "world.xml"
        experiment.write_text(text)
        name = "" if by[0] == "swarmanoid" else "experiment:="
        return self.start(*by, f"{name}{experiment}", "rviz:=false", "record:=run.bag", "force:=true", *arguments)

    def call(self, service, request="{}"):
        """Calls a service as soon as it is offered. @return its answer as text"""
        environment = dict(os.environ, ROS_MASTER_URI=f"http://localhost:{self.port}", ROS_HOSTNAME="localhost")
        deadline = time.monotonic() + LIMIT
        while True:
            done = subprocess.run(["rosservice", "call", "/space/" + service, request], env=environment, timeout=LIMIT,
                                  stdout=subprocess.PIPE, stderr=subprocess.STDOUT, universal_newlines=True,
                                  check=False)
            if done.returncode == 0 or time.monotonic() > deadline:
                return " ".join(done.stdout.replace("\\", "").split())
            time.sleep(0.2)

    def wait_until_busy(self):
        """Requests steps, which a running space rejects, until the answer reports that it is busy."""
        deadline = time.monotonic() + LIMIT
        answer = self.call("step", "ticks: 1")
        while "busy in" not in answer:
            self.assertLess(time.monotonic(), deadline, answer)
            time.sleep(0.5)
            answer = self.call("step", "ticks: 1")

    def assert_bag(self, ticks):
        with rosbag.Bag(str(self.path / "run.bag")) as bag:
            states = [message.tick for _, message, _ in bag.read_messages(topics=["/space/world_state"])]
        self.assertEqual(list(range(ticks + 1)), states)

    def test_a_crash_names_the_robot_and_keeps_the_bag(self):
        for action, what in (("segv_write", "crashed: SIGSEGV"), ("stack_overflow", "crashed: SIGSEGV"),
                           ("abort", "crashed: SIGABRT"), ("exit_0", "called exit")):
            with self.subTest(action=action):
                code, output = self.end_of(self.begin("step", action))
                self.assertEqual(3, code, output)
                self.assertIn(f"swarmanoid: {what} in step of {NAME}, tick 3\n", output)
                self.assert_bag(3)

    def test_a_crash_of_other_plugins_names_them_and_keeps_the_bag(self):
        for who, phase, action, what in ((ENGINE, "move", "assert", "crashed: SIGABRT"),
                                       (ENGINE, "connect", "segv_read", "crashed: SIGSEGV"),
                                       (SENSOR, "sense", "exit_0", "called exit"),
                                       (VISUALISATION, "draw", "segv_write", "crashed: SIGSEGV")):
            with self.subTest(who=who, phase=phase, action=action):
                code, output = self.end_of(self.begin(phase, action, who=who))
                self.assertEqual(4, code, output)
                reason = f"{what} in {phase} of {who}, tick 3"
                self.assertIn(f"swarmanoid: {reason}\n", output)
                self.assertRegex(output, f"stopped after 3 ticks in .* s \\({re.escape(reason)}\\)")
                self.assertNotIn("the controller of", output)
                # the recorder follows the experiment's visualisations
                self.assert_bag(2 if who == VISUALISATION else 3)

    def test_services_answer_while_an_engine_is_late(self):
        process = self.begin("move", "loop", "watchdog:=12", who=ENGINE)
        self.wait_until_busy()
        self.assertIn(f"busy in move of {ENGINE}, tick 3 since", self.call("pause"))
        code, output = self.end_of(process)
        self.assertEqual(4, code, output)
        self.assertIn(f"late: move of {ENGINE}, tick 3 has taken 5 s so far", output)
        self.assertIn(f"swarmanoid: watchdog: more than 12 s in move of {ENGINE}, tick 3\n", output)
        self.assert_bag(3)

    def test_an_endless_step_is_told_of_and_services_answer(self):
        process = self.begin("step", "loop")
        self.wait_until_busy()
        self.assertRegex(self.call("pause"), r"success: False message: \"busy in step of robot 'fb_4' .*, tick 3 since \d+ s\"")
        for service, request in (("reset", "{}"), ("delete", "names: [fb_1]"), ("step", "ticks: 1"),
                                 ("set_command_source", "{names: [fb_1], source: none}")):
            self.assertIn("busy in step of robot 'fb_4'", self.call(service, request))
        process.send_signal(signal.SIGINT)  # roslaunch sends an interrupt, then terminates
        code, output = self.end_of(process)
        self.assertEqual(130, code, output)
        self.assertIn(f"late: step of {NAME}, tick 3 has taken 5 s so far", output)
        self.assertIn(f"swarmanoid: interrupted in step of {NAME}, tick 3\n", output)
        self.assert_bag(3)

    def test_an_interrupted_step_is_no_failure_and_replaces_the_exit_code(self):
        pathlib.Path(self.folder.name, "code.txt").write_text("0\n")
        process = self.begin("step", "loop", "exit_code:=code.txt", by=("roslaunch", str(self.launch_file)))
        self.wait_until_busy()
        process.send_signal(signal.SIGINT)
        _, output = self.end_of(process)
        self.assertRegex(output, r"stopped after 3 ticks in .* s \(interrupted in step of")
        self.assertNotIn("the controller of fb_4 failed", output)
        self.assertEqual("130\n", (self.path / "code.txt").read_text())

    def test_a_crash_has_its_result_though_a_file_cannot_be_completed(self):
        before, plugin = PLACES[VISUALISATION]
        more = plugin.format("<phase>finish</phase><action>throw_runtime_error</action>")
        code, output = self.end_of(self.begin_with(world("step", "segv_write", maxclock=10**6).replace(before, before + more)))
        self.assertEqual(3, code, output)
        self.assertRegex(output, r"ERROR.*told to")
        self.assertRegex(output, r"stopped after 3 ticks in .* s \(crashed: SIGSEGV in step of .*the controller of fb_4 failed")
        self.assert_bag(3)

    def test_the_watchdog_ends_the_run(self):
        code, output = self.end_of(self.begin("step", "loop", "watchdog:=2"))
        self.assertEqual(3, code, output)
        self.assertIn(f"swarmanoid: watchdog: more than 2 s in step of {NAME}, tick 3\n", output)
        self.assert_bag(3)

    def test_the_watchdog_holds_while_the_experiment_is_checked(self):
        code, output = self.end_of(self.begin("init", "loop", "watchdog:=2"))
        self.assertEqual(2, code, output)
        self.assertIn("swarmanoid: watchdog: more than 2 s in init of robot 'fb_4'", output)
        self.assertNotIn("process[", output, "something was started")

    def test_the_result_is_said_when_the_run_is_over_and_not_when_its_process_is(self):
        process = self.begin("never", "nothing", "max_ticks:=5", "on_end:=stay")
        patience = threading.Timer(TIMEOUT, process.send_signal, [signal.SIGINT])
        patience.start()
        said = any("finished after 5 ticks" in line for line in process.stdout)
        is_in_time = patience.is_alive()
        patience.cancel()
        process.send_signal(signal.SIGINT)
        self.end_of(process)
        self.assertTrue(said and is_in_time)

    def test_the_result_is_said_of_a_run_that_ends_while_ros_does(self):
        for _ in range(3):
            code, output = self.end_of(self.begin("step", "raise_int", "max_ticks:=20", "real_time_factor:=0"))
            self.assertIn(code, (0, 130), output)
            self.assertRegex(output, r"finished after 20 ticks|stopped after \d+ ticks")

    def test_what_is_thrown_in_destroy_is_answered_and_the_run_goes_on(self):
        process = self.begin("destroy", "throw_int")
        self.assertIn("for the seed 0; the controller of 'fb_4' failed: destroy: threw the number 7", self.call("reset"))
        self.assertIn("1 done; the controller of 'fb_4' failed: destroy: threw the number 7",
                      self.call("set_command_source", "{names: [fb_4], source: none}"))
        self.assertIn("1 done", self.call("set_command_source", "{names: [fb_4], source: controller}"))
        self.assertIn("1 done; the controller of 'fb_4' failed: destroy: threw the number 7",
                      self.call("delete", "names: [fb_4]"))
        self.assertIn("paused", self.call("pause"))
        process.send_signal(signal.SIGINT)
        self.end_of(process)

    def test_what_is_thrown_in_init_is_answered_and_the_run_goes_on(self):
        process = self.begin("init", "throw_null", only="fb_5")

        def spawn(name):
            return self.call("spawn", "{entities: [{name: %s, type: footbot, controller: mc, engines: [ground], "
                                      "pose: {pose: {orientation: {w: 1.0}, position: {x: 5.0, y: 5.0}}}}]}" % name)
        self.assertIn("controller 'mc' of 'fb_5' does not start: threw a null pointer", spawn("fb_5"))
        self.assertIn("1 done", spawn("fb_6"))
        self.assertIn("there is no entity 'fb_5'", self.call("delete", "names: [fb_5]"))
        process.send_signal(signal.SIGINT)
        self.end_of(process)

    def test_an_experiment_that_does_not_start_is_refused_and_leaves_nothing(self):
        code, output = self.end_of(self.begin("init", "throw_null"))
        self.assertEqual(2, code, output)
        self.assertIn("controller 'mc' of 'fb_4' does not start: threw a null pointer", output)
        process = self.begin("init", "loop_deaf")
        time.sleep(6.0)
        os.kill(int(subprocess.check_output(["pgrep", "-P", str(process.pid)])), signal.SIGKILL)  # roslaunch
        self.end_of(process)
        self.assertNotIn(str(self.path), subprocess.check_output(["ps", "-eo", "args"], universal_newlines=True))


if __name__ == "__main__":
    unittest.main(argv=[pathlib.Path(__file__).name, "-v"])

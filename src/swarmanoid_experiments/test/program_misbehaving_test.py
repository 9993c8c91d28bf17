#!/usr/bin/python3
"""The program with controllers that throw, crash or change the process: it names them, saves files and summary, and
returns the matching exit code."""

import json
import os
import pathlib
import signal
import unittest

from misbehaving_program import CRASHES, OTHER, THROWN, MisbehavingTest
from misbehaving_world import ENGINE, NAME, PLACES, world
from program_world import BAD_INPUT, CONTROLLER_FAILED, FINISHED, STOPPED


class ExceptionTest(MisbehavingTest):
    def test_whatever_a_step_throws_stops_the_robot_alone(self):
        for action, reason in {**THROWN, "throw_that_throws": "threw the number 8" + OTHER}.items():
            with self.subTest(action=action):
                code, summary, errors = self.misbehave("step", action)
                self.assertEqual((code, summary["ticks"]), (CONTROLLER_FAILED, 20), errors)
                self.assertEqual(summary["failed_controllers"], [{"robot": "fb_4", "tick": 3, "reason": reason}])

    def test_a_long_text_is_cut(self):
        code, summary, _ = self.misbehave("step", "throw_long_text")
        self.assertEqual((code, summary["failed_controllers"][0]["reason"]), (CONTROLLER_FAILED, 1000 * "x" + " ..."))

    def test_what_does_not_start_is_bad_input(self):
        for action, reason in THROWN.items():
            with self.subTest(action=action):
                message = f"swarmanoid: world.xml:4: controller 'mc' of 'fb_4' does not start: {reason}\n"
                self.assertEqual(self.misbehave("init", action), (BAD_INPUT, None, message))
                self.assertEqual(self.misbehave("never", "", environment="factory " + action),
                                 (BAD_INPUT, None, message.replace("fb_4", "fb_1")))

    def test_a_mistake_in_its_parameters_names_the_robot(self):
        code, _, errors = self.misbehave("init", "throw_config_error")
        self.assertEqual(code, BAD_INPUT)
        self.assertRegex(errors, "^swarmanoid: world.xml:4: controller 'mc' of 'fb_4' does not start: .*"
                                 "told to, as a configuration error\n$")

    def test_who_fails_at_the_end_has_failed(self):
        for action, reason in THROWN.items():
            with self.subTest(action=action):
                code, summary, errors = self.misbehave("destroy", action)
                self.assertEqual((code, errors), (CONTROLLER_FAILED, f"fb_4: controller failed: destroy: {reason}\n"))
                self.assertTrue(summary["finished"])
                self.assertEqual(summary["failed_controllers"],
                                 [{"robot": "fb_4", "tick": 20, "reason": "destroy: " + reason}])
                self.assert_table(20)


class CrashTest(MisbehavingTest):
    def test_a_crash_in_a_step_is_told_of_and_the_ticks_before_are_kept(self):
        for action, what in CRASHES.items():
            with self.subTest(action=action):
                code, summary, errors = self.misbehave("step", action, "--bag", "run.bag")
                self.assertEqual(code, CONTROLLER_FAILED, errors)
                self.assertEqual(errors.splitlines()[-1], f"swarmanoid: {what} in step of {NAME}, tick 3")
                self.assertEqual((summary["ticks"], summary["finished"]), (3, False))
                self.assertEqual(summary["failed_controllers"],
                                 [{"robot": "fb_4", "tick": 3, "reason": f"{what} in step of {NAME}, tick 3"}])
                self.assert_table(3)
                self.assert_bag(3)
                (self.folder / "run.bag").unlink()

    def test_on_any_thread(self):
        for action in ("segv_write", "stack_overflow", "abort", "exit_0", "thread_exit"):
            with self.subTest(action=action):
                code, summary, errors = self.misbehave("step", action, threads=3)
                self.assertEqual((code, summary["ticks"]), (CONTROLLER_FAILED, 3))
                self.assertEqual(errors.splitlines()[-1], f"swarmanoid: {CRASHES[action]} in step of {NAME}, tick 3")

    def test_in_every_phase(self):
        for action, what in CRASHES.items():
            for phase, named in (("init", "init"), ("destroy", "destroy"), ("destructor", "destruction")):
                if (action, phase) == ("thread_exit", "destructor"):
                    what = "crashed: SIGABRT"  # an exception cannot leave a destructor
                with self.subTest(action=action, phase=phase):
                    code, summary, errors = self.misbehave(phase, action)
                    self.assertEqual(code, CONTROLLER_FAILED, errors)
                    self.assertEqual(errors.splitlines()[-1], f"swarmanoid: {what} in {named} of {NAME}")
                    self.assertEqual(summary is None, phase == "init")
                    if summary is not None:
                        self.assertEqual(summary["failed_controllers"][0]["robot"], "fb_4")
                        self.assert_table(20)

    def test_the_state_hash_is_that_of_the_last_tick_whatever_a_controller_writes_when_it_goes(self):
        before, plugin = PLACES[ENGINE]  # makes the space known to the controller
        text = world("destroy", "spoil_state").replace(before, before + plugin.format("<phase>never</phase><action>nothing</action>"))
        (self.folder / "world.xml").write_text(text)
        done = self.call("run", "world.xml", "--quiet", "--force", "--hashes", "hashes.txt")
        self.assertEqual(done.returncode, CONTROLLER_FAILED, done.stderr)
        self.assertEqual(done.stderr, f"swarmanoid: crashed: SIGSEGV in destroy of {NAME}\n")
        last = (self.folder / "hashes.txt").read_text().splitlines()[-1]
        self.assertEqual(f"20 {json.loads(done.stdout)['state_hash']}", last)

    def test_while_a_library_is_loaded(self):
        for action, what in (("segv_write", "crashed: SIGSEGV"), ("exit_0", "called exit"),
                           ("throw_int", "crashed: SIGABRT")):
            with self.subTest(action=action):
                code, summary, errors = self.misbehave("never", "", environment="load " + action)
                self.assertEqual((code, summary), (CONTROLLER_FAILED, None))
                self.assertEqual(errors.splitlines()[-1],
                                 f"swarmanoid: {what} in loading of library 'misbehaving_controllers'")

    def test_a_crash_that_is_in_no_call_is_the_simulator_s(self):
        code, _, errors = self.misbehave("step", "segv_on_another_thread")
        self.assertEqual(code, -signal.SIGSEGV)
        self.assertEqual(errors, "swarmanoid: crashed: SIGSEGV in the simulator (this thread is not in users' code)\n")

    def test_memory_that_is_spoilt_ends_in_time(self):
        for action in ("free_twice", "spoil_heap"):
            with self.subTest(action=action):
                code, _, errors = self.misbehave("step", action)
                # the message names the next user of memory: the controller, another plugin, or the simulator
                self.assertIn(code, (CONTROLLER_FAILED, STOPPED, -signal.SIGABRT, -signal.SIGBUS, -signal.SIGSEGV))
                self.assertIn("swarmanoid: crashed: SIG", errors)


class SurroundingsTest(MisbehavingTest):
    def outputs(self, phase, action, environment=""):
        """Returns exit code, summary without times, table and hashes of a run."""
        code, summary, errors = self.misbehave(phase, action, "--hashes", "hashes.txt", "--profile", maxclock=1200,
                                               environment=environment)
        for name in ("wall_s", "real_time_factor", "robot_ticks_per_s"):
            summary.pop(name)
        files = [(self.folder / name).read_text() for name in ("table.txt", "hashes.txt")]
        (self.folder / "hashes.txt").unlink()
        return [code, summary, *files], errors

    def test_numbers_are_as_before_whatever_locale_a_controller_sets(self):
        good, _ = self.outputs("never", "nothing")
        self.assertEqual(good[0], FINISHED)
        for action in ("global_locale", "setlocale"):
            for phase in ("init", "step", "destroy", "load"):
                with self.subTest(action=action, phase=phase):
                    outputs, errors = self.outputs(phase, action, f"{phase} {action}")
                    self.assertEqual(outputs, good)
                    if action == "global_locale":
                        self.assertEqual(errors.count("users' code has changed the locale; it is put back"), 1)

    def test_two_libraries_with_one_label(self):
        library = next(file for prefix in os.environ["CMAKE_PREFIX_PATH"].split(":")
                       for file in (pathlib.Path(prefix) / "lib").glob("libmisbehaving_controllers.so"))
        (self.folder / "libtwin.so").write_bytes(library.read_bytes())
        twin = '<misbehaving id="twin" library="./libtwin.so"><actuators><footbot_wheels/></actuators></misbehaving>'
        text = world()
        file = self.world(text=text.replace("</controllers>", twin + "</controllers>").replace("{", "{{"))
        self.assert_refused(f"{file}:8: found the label 'misbehaving' in two libraries "
                            "(libmisbehaving_controllers.so, libtwin.so), allowed: one in a process", "run", file)
        file = self.world(text=text.replace("misbehaving_controllers", "./libtwin.so").replace("{", "{{"))
        self.assertEqual(self.call("run", file, "--quiet", "--force").returncode, FINISHED)


if __name__ == "__main__":
    unittest.main(argv=[pathlib.Path(__file__).name, "-v"])

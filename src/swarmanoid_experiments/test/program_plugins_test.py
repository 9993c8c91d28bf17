#!/usr/bin/python3
"""The program with misbehaving engines, devices, rules and visualisations: it names them, saves files and summary, and
returns the matching exit code."""

import json
import pathlib
import signal
import time
import unittest

from misbehaving_program import CRASHES, OTHER, THROWN, TIMEOUT, MisbehavingTest
from misbehaving_world import ACTUATOR, ENGINE, RULE, SENSOR, VISUALISATION
from program_world import BAD_INPUT, FINISHED, INTERRUPTED, STOPPED


class PluginTest(MisbehavingTest):
    """Engines, devices, rules, visualisations: the message names the plugin, and the ticks before are saved."""
    CALLS = ((ENGINE, "readMirrors"), (ENGINE, "move"), (ENGINE, "connect"), (SENSOR, "sense"), (SENSOR, "report"),
             (ACTUATOR, "actuate"), (ACTUATOR, "afterMove"), (RULE, "beforeTick"))

    def assert_ended(self, outcome, reason, ticks, rows=None):
        """Expects that the run stopped after `ticks` ticks, `rows` of which are in the table."""
        code, summary, errors = outcome
        self.assertEqual(code, STOPPED, errors)
        self.assertEqual(errors.splitlines()[-1], f"swarmanoid: {reason}")
        self.assertEqual((summary["ticks"], summary["failed_controllers"]), (ticks, []))
        self.assert_table(ticks if rows is None else rows)

    def test_a_crash_in_every_call(self):
        for who, phase in self.CALLS:
            for action, what in (("segv_read", "crashed: SIGSEGV"), ("abort", "crashed: SIGABRT"),
                               ("exit_0", "called exit")):
                with self.subTest(who=who, phase=phase, action=action):
                    outcome = self.misbehave(phase, action, "--bag", "run.bag", who=who)
                    self.assert_ended(outcome, f"{what} in {phase} of {who}, tick 3", 3)
                    self.assertFalse(outcome[1]["finished"])
                    self.assert_bag(3)
                    (self.folder / "run.bag").unlink()

    def test_every_crash_of_an_engine(self):
        for action, what in CRASHES.items():
            with self.subTest(action=action):
                self.assert_ended(self.misbehave("move", action, who=ENGINE), f"{what} in move of {ENGINE}, tick 3", 3)

    def test_a_crash_while_somebody_is_handed_over(self):
        (self.folder / "done.xml").write_text('<interventions><handover tick="3" entity="fb_4" engine="bad"/></interventions>')
        outcome = self.misbehave("invalidPoseReason", "segv_read", "--interventions", "done.xml", who=ENGINE)
        self.assert_ended(outcome, f"crashed: SIGSEGV in handover of {ENGINE}, tick 3", 3)

    def test_what_an_assertion_says_is_kept(self):
        outcome = self.misbehave("move", "assert", who=ENGINE)
        self.assert_ended(outcome, f"crashed: SIGABRT in move of {ENGINE}, tick 3", 3)
        self.assertEqual(outcome[2].splitlines()[0], "swarmanoid: b2_polygon_shape.cpp:123: ComputeMass: "
                                                     "Assertion `area > b2_epsilon' failed.")

    def test_on_any_thread(self):
        for action in ("segv_write", "stack_overflow", "abort", "thread_exit"):
            with self.subTest(action=action):
                self.assert_ended(self.misbehave("move", action, who=ENGINE, threads=3),
                                  f"{CRASHES[action]} in move of {ENGINE}, tick 3", 3)

    def test_visualisations_that_crash_do_not_keep_others_from_completing_their_files(self):
        # the table's visualisation follows them
        for phase, when, ticks, rows in (("draw", ", tick 3", 3, 2), ("flush", "", 0, 0), ("finish", "", 20, 20)):
            for action in ("segv_read", "abort", "wait_for_itself"):
                with self.subTest(phase=phase, action=action):
                    what = CRASHES.get(action, "watchdog: more than 1 s")
                    outcome = self.misbehave(phase, action, "--watchdog", "1", who=VISUALISATION)
                    self.assert_ended(outcome, f"{what} in {phase} of {VISUALISATION}{when}", ticks, rows)
                    self.assertEqual(outcome[1]["finished"], phase == "finish")

    def test_while_it_is_configured(self):
        for who in (ENGINE, SENSOR, ACTUATOR, RULE, VISUALISATION):
            for action, what in (("segv_read", "crashed: SIGSEGV"), ("exit_0", "called exit")):
                with self.subTest(who=who, action=action):
                    message = f"swarmanoid: {what} in configure of {who}\n"
                    self.assertEqual(self.misbehave("configure", action, who=who), (STOPPED, None, message))
                    if who != VISUALISATION:  # validation does not create them
                        done = self.call("validate", "world.xml")
                        self.assertEqual((done.returncode, done.stdout, done.stderr), (STOPPED, "", message))

    def test_the_watchdog_ends_it(self):
        for who, phase in self.CALLS:
            with self.subTest(who=who, phase=phase):
                self.assert_ended(self.misbehave(phase, "loop", "--watchdog", "0.5", who=who),
                                  f"watchdog: more than 1 s in {phase} of {who}, tick 3", 3)

    def test_it_is_told_of_and_the_second_signal_ends_it(self):
        process = self.start("move", "loop", "--bag", "run.bag", who=ENGINE)
        self.read_until(process, f"late: move of {ENGINE}, tick 3 has taken 5 s so far")
        process.send_signal(signal.SIGINT)
        process.send_signal(signal.SIGTERM)
        output, errors = process.communicate(timeout=TIMEOUT)
        self.assertEqual((process.returncode, errors),
                         (INTERRUPTED, f"swarmanoid: interrupted in move of {ENGINE}, tick 3\n"))
        self.assertEqual(json.loads(output)["ticks"], 3)
        self.assert_table(3)
        self.assert_bag(3)

    def test_the_second_signal_leaves_time_to_complete_files(self):
        process = self.start("finish", "sleep_1", who=VISUALISATION)
        while not (self.folder / "table.txt").exists() or (self.folder / "table.txt").stat().st_size < 100:
            time.sleep(0.01)
        process.send_signal(signal.SIGINT)
        process.send_signal(signal.SIGTERM)
        output, errors = process.communicate(timeout=TIMEOUT)
        self.assertIn((process.returncode, errors), ((INTERRUPTED, ""), (FINISHED, "")))
        self.assert_table(json.loads(output)["ticks"])

    def test_whatever_it_throws_stops_the_run_and_names_it(self):
        for action, reason in THROWN.items():
            with self.subTest(action=action):
                code, summary, errors = self.misbehave("configure", action, who=VISUALISATION)
                self.assertEqual((code, summary), (BAD_INPUT, None))
                self.assertIn(f":17: {VISUALISATION} cannot be configured: {reason}\n", errors)
                named = f"{VISUALISATION} {reason}" if OTHER in reason else reason
                code, summary, errors = self.misbehave("draw", action, who=VISUALISATION)
                self.assertEqual((code, errors), (STOPPED, f"swarmanoid: stopped in tick 3: {named}\n"))
                self.assertEqual(summary["ticks"], 3)
                code, summary, errors = self.misbehave("finish", action, who=VISUALISATION)
                self.assertEqual((code, errors), (STOPPED, f"swarmanoid: {named}\n"))
                self.assert_table(20)

    def test_visualisations_see_a_tick_after_which_a_rule_throws_but_not_one_that_it_crashes(self):
        for action, what in (("segv_read", "crashed: SIGSEGV"), ("exit_0", "called exit")):
            with self.subTest(action=action):
                self.assert_ended(self.misbehave("afterTick", action, who=RULE),
                                  f"{what} in afterTick of {RULE}, tick 3", 3, 2)
        code, summary, errors = self.misbehave("afterTick", "throw_runtime_error", who=RULE)
        self.assertEqual((code, errors), (STOPPED, f"swarmanoid: stopped in tick 3: {RULE}: told to\n"))
        self.assertEqual(summary["ticks"], 3)
        self.assert_table(3)

    def test_a_rule_that_fails_before_the_run_begins(self):
        for action, reason in (("segv_read", f"crashed: SIGSEGV in reset of {RULE}"),
                             ("throw_int", f"{RULE} threw the number 7{OTHER}"),
                             ("throw_runtime_error", f"{RULE}: told to")):
            with self.subTest(action=action):
                self.assertEqual(self.misbehave("reset", action, who=RULE), (STOPPED, None, f"swarmanoid: {reason}\n"))

    def test_what_devices_throw_names_them(self):
        for who, phase in self.CALLS:
            with self.subTest(who=who, phase=phase):
                code, _, errors = self.misbehave(phase, "throw_int", who=who)
                self.assertEqual((code, errors),
                                 (STOPPED, f"swarmanoid: stopped in tick 3: {who} threw the number 7{OTHER}\n"))
                self.assert_table(3)


if __name__ == "__main__":
    unittest.main(argv=[pathlib.Path(__file__).name, "-v"])

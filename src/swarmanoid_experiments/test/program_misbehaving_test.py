#!/usr/bin/python3
"""The program and users' code that misbehaves: it is named, files and summary are kept, the exit code says it."""

import fcntl
import json
import os
import pathlib
import signal
import subprocess
import time
import unittest

import rosbag

from misbehaving_world import ACTUATOR, ENGINE, NAME, PLACES, ROBOTS, SENSOR, VISUALISATION, world, world_with
from program_world import BAD_INPUT, CONTROLLER_FAILED, FINISHED, INTERRUPTED, HEADER, STOPPED, ProgramTest

TIMEOUT = 60.0  # [s]

OTHER = ", which is no std::exception"
THROWN = {
    "throw_runtime_error": "told to",
    "throw_derived": "a derived exception",
    "throw_bad_alloc": "std::bad_alloc",
    "throw_int": "threw the number 7" + OTHER,
    "throw_string": "threw the text 'a string'" + OTHER,
    "throw_text": "threw the text 'a text'" + OTHER,
    "throw_null": "threw a null pointer" + OTHER,
    "throw_nullptr": "threw a null pointer" + OTHER,
    "throw_thing": "threw a 'swarmanoid::test::(anonymous namespace)::Thing'" + OTHER,
    "throw_pointer": "threw a 'std::runtime_error*'" + OTHER,
    "throw_without_text": "threw an exception without a text",
    "throw_null_text": "threw an exception without a text",
    "throw_nested": "the outer one",
}
CRASHES = {
    "segv_read": "crashed: SIGSEGV", "segv_write": "crashed: SIGSEGV", "segv_call": "crashed: SIGSEGV",
    "segv_raise": "crashed: SIGSEGV", "stack_overflow": "crashed: SIGSEGV", "bus": "crashed: SIGBUS",
    "fpe": "crashed: SIGFPE", "ill": "crashed: SIGILL", "abort": "crashed: SIGABRT", "terminate": "crashed: SIGABRT",
    "pure_virtual": "crashed: SIGABRT", "throw_through_noexcept": "crashed: SIGABRT",
    "exit_0": "called exit", "exit_7": "called exit", "quick_exit_0": "called quick_exit",
    "thread_exit": "called pthread_exit",
}


class MisbehavingTest(ProgramTest):
    @staticmethod
    def text(phase, deed, who=None, **more):
        """@param who: nobody but the fourth robot's controller if it is not given"""
        return world(phase, deed, **more) if who is None else world_with(who, phase, deed, **more)

    def misbehave(self, phase, deed, *arguments, environment="", **more):
        """Runs the experiment to its end. @return exit code, summary or None, error stream"""
        (self.folder / "world.xml").write_text(self.text(phase, deed, **more))
        done = subprocess.run(["swarmanoid", "run", "world.xml", "--quiet", "--force", *arguments], cwd=self.folder,
                              env=dict(os.environ, MISBEHAVING=environment), timeout=TIMEOUT, stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE, encoding="utf-8", errors="replace", check=False)
        return done.returncode, json.loads(done.stdout) if done.stdout else None, done.stderr

    def start(self, phase, deed, *arguments, preexec_fn=None, **more):
        (self.folder / "world.xml").write_text(self.text(phase, deed, **more))
        # Python starts children with SIGINT as it has it itself; the shell of a test may ignore it
        process = subprocess.Popen(["swarmanoid", "run", "world.xml", "--quiet", "--force", *arguments], cwd=self.folder,
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE, encoding="utf-8",
                                   preexec_fn=preexec_fn)
        for clean_up in (process.wait, process.stderr.close, process.stdout.close, process.kill):
            self.addCleanup(clean_up)
        return process

    def read_until(self, process, text):
        lines = []
        for line in process.stderr:
            lines.append(line)
            if text in line:
                return line
        self.fail(f"not found: {text} in {lines}")

    def assert_table(self, ticks):
        """The table has the state before the first tick, and after each of these."""
        lines = (self.folder / "table.txt").read_text().splitlines(keepends=True)
        self.assertEqual(lines[0], HEADER)
        self.assertEqual(len(lines), 1 + (ticks + 1) * len(ROBOTS))
        self.assertTrue(lines[-1].endswith("\n"))

    def assert_bag(self, ticks):
        with rosbag.Bag(str(self.folder / "run.bag")) as bag:
            states = [message.tick for _, message, _ in bag.read_messages(topics=["/space/world_state"])]
        self.assertEqual(states, list(range(ticks + 1)))


class ExceptionTest(MisbehavingTest):
    def test_whatever_a_step_throws_stops_the_robot_alone(self):
        for deed, reason in {**THROWN, "throw_that_throws": "threw the number 8" + OTHER}.items():
            with self.subTest(deed=deed):
                code, summary, errors = self.misbehave("step", deed)
                self.assertEqual((code, summary["ticks"]), (CONTROLLER_FAILED, 20), errors)
                self.assertEqual(summary["failed_controllers"], [{"robot": "fb_4", "tick": 3, "reason": reason}])

    def test_a_long_text_is_cut(self):
        code, summary, _ = self.misbehave("step", "throw_long_text")
        self.assertEqual((code, summary["failed_controllers"][0]["reason"]), (CONTROLLER_FAILED, 1000 * "x" + " ..."))

    def test_what_does_not_start_is_bad_input(self):
        for deed, reason in THROWN.items():
            with self.subTest(deed=deed):
                message = f"swarmanoid: world.xml:4: controller 'mc' of 'fb_4' does not start: {reason}\n"
                self.assertEqual(self.misbehave("init", deed), (BAD_INPUT, None, message))
                self.assertEqual(self.misbehave("never", "", environment="factory " + deed),
                                 (BAD_INPUT, None, message.replace("fb_4", "fb_1")))

    def test_a_mistake_in_its_parameters_names_the_robot(self):
        code, _, errors = self.misbehave("init", "throw_config_error")
        self.assertEqual(code, BAD_INPUT)
        self.assertRegex(errors, "^swarmanoid: world.xml:4: controller 'mc' of 'fb_4' does not start: .*"
                                 "told to, as a configuration error\n$")

    def test_who_fails_at_the_end_has_failed(self):
        for deed, reason in THROWN.items():
            with self.subTest(deed=deed):
                code, summary, errors = self.misbehave("destroy", deed)
                self.assertEqual((code, errors), (CONTROLLER_FAILED, f"fb_4: controller failed: destroy: {reason}\n"))
                self.assertTrue(summary["finished"])
                self.assertEqual(summary["failed_controllers"],
                                 [{"robot": "fb_4", "tick": 20, "reason": "destroy: " + reason}])
                self.assert_table(20)


class CrashTest(MisbehavingTest):
    def test_a_crash_in_a_step_is_told_of_and_the_ticks_before_are_kept(self):
        for deed, what in CRASHES.items():
            with self.subTest(deed=deed):
                code, summary, errors = self.misbehave("step", deed, "--bag", "run.bag")
                self.assertEqual(code, CONTROLLER_FAILED, errors)
                self.assertEqual(errors.splitlines()[-1], f"swarmanoid: {what} in step of {NAME}, tick 3")
                self.assertEqual((summary["ticks"], summary["finished"]), (3, False))
                self.assertEqual(summary["failed_controllers"],
                                 [{"robot": "fb_4", "tick": 3, "reason": f"{what} in step of {NAME}, tick 3"}])
                self.assert_table(3)
                self.assert_bag(3)
                (self.folder / "run.bag").unlink()

    def test_on_any_thread(self):
        for deed in ("segv_write", "stack_overflow", "abort", "exit_0", "thread_exit"):
            with self.subTest(deed=deed):
                code, summary, errors = self.misbehave("step", deed, threads=3)
                self.assertEqual((code, summary["ticks"]), (CONTROLLER_FAILED, 3))
                self.assertEqual(errors.splitlines()[-1], f"swarmanoid: {CRASHES[deed]} in step of {NAME}, tick 3")

    def test_in_every_phase(self):
        for deed, what in CRASHES.items():
            for phase, named in (("init", "init"), ("destroy", "destroy"), ("destructor", "destruction")):
                if (deed, phase) == ("thread_exit", "destructor"):
                    what = "crashed: SIGABRT"  # nothing leaves a destructor
                with self.subTest(deed=deed, phase=phase):
                    code, summary, errors = self.misbehave(phase, deed)
                    self.assertEqual(code, CONTROLLER_FAILED, errors)
                    self.assertEqual(errors.splitlines()[-1], f"swarmanoid: {what} in {named} of {NAME}")
                    self.assertEqual(summary is None, phase == "init")
                    if summary is not None:
                        self.assertEqual(summary["failed_controllers"][0]["robot"], "fb_4")
                        self.assert_table(20)

    def test_the_state_hash_is_that_of_the_last_tick_whatever_a_controller_writes_when_it_goes(self):
        before, plugin = PLACES[ENGINE]  # from which the controller knows where to write
        text = world("destroy", "spoil_state").replace(before, before + plugin.format("<phase>never</phase><deed>nothing</deed>"))
        (self.folder / "world.xml").write_text(text)
        done = self.call("run", "world.xml", "--quiet", "--force", "--hashes", "hashes.txt")
        self.assertEqual(done.returncode, CONTROLLER_FAILED, done.stderr)
        self.assertEqual(done.stderr, f"swarmanoid: crashed: SIGSEGV in destroy of {NAME}\n")
        last = (self.folder / "hashes.txt").read_text().splitlines()[-1]
        self.assertEqual(f"20 {json.loads(done.stdout)['state_hash']}", last)

    def test_while_a_library_is_loaded(self):
        for deed, what in (("segv_write", "crashed: SIGSEGV"), ("exit_0", "called exit"),
                           ("throw_int", "crashed: SIGABRT")):
            with self.subTest(deed=deed):
                code, summary, errors = self.misbehave("never", "", environment="load " + deed)
                self.assertEqual((code, summary), (CONTROLLER_FAILED, None))
                self.assertEqual(errors.splitlines()[-1],
                                 f"swarmanoid: {what} in loading of library 'misbehaving_controllers'")

    def test_a_crash_that_is_in_no_call_is_the_simulator_s(self):
        code, _, errors = self.misbehave("step", "segv_on_another_thread")
        self.assertEqual(code, -signal.SIGSEGV)
        self.assertEqual(errors, "swarmanoid: crashed: SIGSEGV in the simulator (this thread is not in users' code)\n")

    def test_memory_that_is_spoilt_ends_in_time(self):
        for deed in ("free_twice", "spoil_heap"):
            with self.subTest(deed=deed):
                code, _, errors = self.misbehave("step", deed)
                # whoever uses memory next is named: the controller, another plugin, or the simulator
                self.assertIn(code, (CONTROLLER_FAILED, STOPPED, -signal.SIGABRT, -signal.SIGSEGV))
                self.assertIn("swarmanoid: crashed: SIG", errors)


class EndlessTest(MisbehavingTest):
    def test_the_second_signal_ends_it(self):
        for number in (signal.SIGINT, signal.SIGTERM):
            for deed in ("loop", "loop_deaf", "sleep_for_ever", "wait_for_itself"):
                with self.subTest(number=number, deed=deed):
                    process = self.start("step", deed, "--bag", "run.bag")
                    self.read_until(process, f"late: step of {NAME}, tick 3 has taken 5 s so far")
                    process.send_signal(number)
                    with self.assertRaises(subprocess.TimeoutExpired):
                        process.wait(timeout=0.5)
                    process.send_signal(number)
                    output, errors = process.communicate(timeout=TIMEOUT)
                    self.assertEqual(process.returncode, INTERRUPTED, errors)
                    self.assertEqual(errors, f"swarmanoid: interrupted in step of {NAME}, tick 3\n")
                    self.assertEqual(json.loads(output)["ticks"], 3)
                    self.assert_table(3)
                    self.assert_bag(3)
                    (self.folder / "run.bag").unlink()

    def test_a_terminal_that_closes_asks_once_however_often_it_says_so(self):
        process = self.start("step", "sleep_7", preexec_fn=lambda: signal.signal(signal.SIGHUP, signal.SIG_DFL))
        self.read_until(process, f"late: step of {NAME}, tick 3 has taken 5 s so far")
        for _ in range(3):
            process.send_signal(signal.SIGHUP)
            time.sleep(0.1)
        output, errors = process.communicate(timeout=TIMEOUT)
        self.assertEqual((process.returncode, errors), (INTERRUPTED, ""))
        self.assertEqual(json.loads(output)["ticks"], 4)  # the call has returned
        self.assert_table(4)

    def test_also_in_destroy(self):
        process = self.start("destroy", "loop")
        self.read_until(process, f"late: destroy of {NAME} has taken 5 s so far")
        process.send_signal(signal.SIGINT)
        process.send_signal(signal.SIGTERM)
        output, errors = process.communicate(timeout=TIMEOUT)
        self.assertEqual(process.returncode, INTERRUPTED, errors)
        self.assertTrue(json.loads(output)["finished"])

    def test_the_first_signal_ends_init(self):
        process = self.start("init", "loop")
        self.read_until(process, f"late: init of {NAME} has taken 5 s so far")
        process.send_signal(signal.SIGINT)
        self.assertEqual(process.wait(timeout=TIMEOUT), -signal.SIGINT)

    def test_the_watchdog_ends_it(self):
        code, summary, errors = self.misbehave("step", "loop", "--watchdog", "1")
        self.assertEqual((code, errors), (CONTROLLER_FAILED,
                                          f"swarmanoid: watchdog: more than 1 s in step of {NAME}, tick 3\n"))
        self.assertEqual(summary["failed_controllers"][0]["robot"], "fb_4")
        self.assert_table(3)
        for watchdog in ("0", "-1", "nan", "x"):
            self.assertEqual(self.misbehave("never", "nothing", "--watchdog", watchdog)[0], BAD_INPUT, watchdog)

    def test_what_returns_while_the_run_is_closed_does_not_go_on(self):
        (self.folder / "world.xml").write_text(world("step", "sleep_7"))
        ours, theirs = os.pipe()
        size = fcntl.fcntl(ours, fcntl.F_GETPIPE_SZ)
        os.write(theirs, size * b" ")  # so that the summary waits until this is read
        with open(ours, encoding="utf-8") as output, subprocess.Popen(
                ["swarmanoid", "run", "world.xml", "--quiet", "--force", "--watchdog", "6", "--hashes", "hashes.txt"],
                cwd=self.folder, stdout=theirs, stderr=subprocess.PIPE, encoding="utf-8") as process:
            os.close(theirs)
            self.read_until(process, f"watchdog: more than 6 s in step of {NAME}, tick 3")
            time.sleep(3.0)  # the call returns after one of them
            summary = json.loads(output.read())
            self.assertEqual(process.wait(timeout=TIMEOUT), CONTROLLER_FAILED)
        self.assertEqual((summary["ticks"], summary["finished"]), (3, False))
        self.assert_table(3)
        hashes = (self.folder / "hashes.txt").read_text().splitlines()
        self.assertEqual([line.split()[0] for line in hashes], ["0", "1", "2", "3"])
        self.assertEqual(hashes[-1].split()[1], summary["state_hash"])

    def test_who_is_only_slow_is_told_of_once_and_goes_on(self):
        code, summary, errors = self.misbehave("step", "sleep_7", "--watchdog", "30")
        self.assertEqual((code, summary["ticks"]), (FINISHED, 20))
        self.assertEqual(errors, f"swarmanoid: late: step of {NAME}, tick 3 has taken 5 s so far\n")

    def test_validate_ends_with_who_has_started_it(self):
        (self.folder / "world.xml").write_text(world("init", "loop_deaf"))
        script = "swarmanoid validate world.xml --end-with-parent & echo $!; sleep 1000"
        parent = subprocess.Popen(["bash", "-c", script], cwd=self.folder, stdout=subprocess.PIPE,
                                  stderr=subprocess.DEVNULL, encoding="utf-8", start_new_session=True)
        child = pathlib.Path("/proc") / parent.stdout.readline().strip()
        time.sleep(2.0)
        self.assertIn("validate", (child / "cmdline").read_text())
        parent.kill()
        parent.wait()
        parent.stdout.close()
        deadline = time.monotonic() + TIMEOUT
        while child.exists() and "Z" not in (child / "stat").read_text().split()[2]:
            self.assertLess(time.monotonic(), deadline)
            time.sleep(0.1)


class PluginTest(MisbehavingTest):
    """Engines, devices, visualisations: who it was is named, and the ticks before are kept."""
    CALLS = ((ENGINE, "readMirrors"), (ENGINE, "move"), (ENGINE, "connect"), (SENSOR, "sense"), (SENSOR, "report"),
             (ACTUATOR, "actuate"), (ACTUATOR, "afterMove"))

    def assert_ended(self, outcome, reason, ticks, rows=None):
        """The run has stopped after so many ticks, of which the table has those rows."""
        code, summary, errors = outcome
        self.assertEqual(code, STOPPED, errors)
        self.assertEqual(errors.splitlines()[-1], f"swarmanoid: {reason}")
        self.assertEqual((summary["ticks"], summary["failed_controllers"]), (ticks, []))
        self.assert_table(ticks if rows is None else rows)

    def test_a_crash_in_every_call(self):
        for who, phase in self.CALLS:
            for deed, what in (("segv_read", "crashed: SIGSEGV"), ("abort", "crashed: SIGABRT"),
                               ("exit_0", "called exit")):
                with self.subTest(who=who, phase=phase, deed=deed):
                    outcome = self.misbehave(phase, deed, "--bag", "run.bag", who=who)
                    self.assert_ended(outcome, f"{what} in {phase} of {who}, tick 3", 3)
                    self.assertFalse(outcome[1]["finished"])
                    self.assert_bag(3)
                    (self.folder / "run.bag").unlink()

    def test_every_crash_of_an_engine(self):
        for deed, what in CRASHES.items():
            with self.subTest(deed=deed):
                self.assert_ended(self.misbehave("move", deed, who=ENGINE), f"{what} in move of {ENGINE}, tick 3", 3)

    def test_what_an_assertion_says_is_kept(self):
        outcome = self.misbehave("move", "assert", who=ENGINE)
        self.assert_ended(outcome, f"crashed: SIGABRT in move of {ENGINE}, tick 3", 3)
        self.assertEqual(outcome[2].splitlines()[0], "swarmanoid: b2_polygon_shape.cpp:123: ComputeMass: "
                                                     "Assertion `area > b2_epsilon' failed.")

    def test_on_any_thread(self):
        for deed in ("segv_write", "stack_overflow", "abort", "thread_exit"):
            with self.subTest(deed=deed):
                self.assert_ended(self.misbehave("move", deed, who=ENGINE, threads=3),
                                  f"{CRASHES[deed]} in move of {ENGINE}, tick 3", 3)

    def test_visualisations_that_crash_do_not_keep_others_from_completing_their_files(self):
        # the table comes after them
        for phase, when, ticks, rows in (("draw", ", tick 3", 3, 2), ("flush", "", 0, 0), ("finish", "", 20, 20)):
            for deed in ("segv_read", "abort", "wait_for_itself"):
                with self.subTest(phase=phase, deed=deed):
                    what = CRASHES.get(deed, "watchdog: more than 1 s")
                    outcome = self.misbehave(phase, deed, "--watchdog", "1", who=VISUALISATION)
                    self.assert_ended(outcome, f"{what} in {phase} of {VISUALISATION}{when}", ticks, rows)
                    self.assertEqual(outcome[1]["finished"], phase == "finish")

    def test_while_it_is_configured(self):
        for who in (ENGINE, SENSOR, ACTUATOR, VISUALISATION):
            for deed, what in (("segv_read", "crashed: SIGSEGV"), ("exit_0", "called exit")):
                with self.subTest(who=who, deed=deed):
                    message = f"swarmanoid: {what} in configure of {who}\n"
                    self.assertEqual(self.misbehave("configure", deed, who=who), (STOPPED, None, message))
                    if who != VISUALISATION:  # those are not made to validate a file
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
        for deed, reason in THROWN.items():
            with self.subTest(deed=deed):
                code, summary, errors = self.misbehave("configure", deed, who=VISUALISATION)
                self.assertEqual((code, summary), (BAD_INPUT, None))
                self.assertIn(f":17: {VISUALISATION} cannot be configured: {reason}\n", errors)
                named = f"{VISUALISATION} {reason}" if OTHER in reason else reason
                code, summary, errors = self.misbehave("draw", deed, who=VISUALISATION)
                self.assertEqual((code, errors), (STOPPED, f"swarmanoid: stopped in tick 3: {named}\n"))
                self.assertEqual(summary["ticks"], 3)
                code, summary, errors = self.misbehave("finish", deed, who=VISUALISATION)
                self.assertEqual((code, errors), (STOPPED, f"swarmanoid: {named}\n"))
                self.assert_table(20)

    def test_what_devices_throw_names_them(self):
        for who, phase in self.CALLS:
            with self.subTest(who=who, phase=phase):
                code, _, errors = self.misbehave(phase, "throw_int", who=who)
                self.assertEqual((code, errors),
                                 (STOPPED, f"swarmanoid: stopped in tick 3: {who} threw the number 7{OTHER}\n"))
                self.assert_table(3)


class SurroundingsTest(MisbehavingTest):
    def outputs(self, phase, deed, environment=""):
        """Exit code, summary without times, table and hashes of a run."""
        code, summary, errors = self.misbehave(phase, deed, "--hashes", "hashes.txt", "--profile", maxclock=1200,
                                               environment=environment)
        for name in ("wall_s", "real_time_factor", "robot_ticks_per_s"):
            summary.pop(name)
        files = [(self.folder / name).read_text() for name in ("table.txt", "hashes.txt")]
        (self.folder / "hashes.txt").unlink()
        return [code, summary, *files], errors

    def test_numbers_are_as_before_whatever_locale_a_controller_sets(self):
        good, _ = self.outputs("never", "nothing")
        self.assertEqual(good[0], FINISHED)
        for deed in ("global_locale", "setlocale"):
            for phase in ("init", "step", "destroy", "load"):
                with self.subTest(deed=deed, phase=phase):
                    outputs, errors = self.outputs(phase, deed, f"{phase} {deed}")
                    self.assertEqual(outputs, good)
                    if deed == "global_locale":
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

#!/usr/bin/python3
"""Controllers that end or damage their process for some seeds: these runs have rows with the failure, and all others are made."""

import contextlib
import csv
import errno
import json
import os
import signal
import time
import unittest
from unittest import mock

import psutil
from commands import CONTROLLER_FAILED, INTERRUPTED, PATIENCE_S, SCRIPTED, STOPPED, CommandsTest, workers_of
from swarmanoid_studies import makers, worker_setup
from swarmanoid_studies.mistakes import RunsStopped
from swarmanoid_studies.runs import MOST_FAILURE, RunRequest

SEEDS, BAD = 8, 1   # number of seeds, and least number of bad ones, which the robot's random numbers select
CHANCE = 0.3
SCRIPT = """import os, re, signal, subprocess, time

class Drive:
    def step(self, robot):
        if robot.tick == 2 and robot.uniform() < %s:
            %s
"""
TRIED = "the process that made the run ended in it, each of 3 times, "
# action of a controller, and failure in its row
ACTIONS = {
    "os.abort()": TRIED + "by SIGABRT",
    "os._exit(0)": TRIED + "with exit code 0",
    "os.closerange(0, 65536)": TRIED + "with exit code 1",
    "os.closerange(3, 65536); time.sleep(600)": TRIED + "it closed its connection",
    "os.kill(os.getpid(), signal.SIGKILL)": TRIED + "by SIGKILL",
    "signal.signal(signal.SIGINT, signal.SIG_DFL); os.kill(0, signal.SIGINT)": TRIED + "by SIGINT",
    "subprocess.Popen(['sleep', '600'], close_fds=False); os.abort()": TRIED + "by SIGABRT",
}


class MisbehavingRunsTest(CommandsTest):
    def write(self, action, chance=CHANCE):
        (self.folder / "world.xml").write_text(SCRIPTED.replace("400", "9"))
        (self.folder / "drive.py").write_text(SCRIPT % (chance, action))

    def make(self, action):
        """@return failures by seed, and the state of the other runs by seed"""
        self.write(action)
        self.addCleanup(makers.stop)
        makers.stop()   # the next maker reads the script again
        made = makers.make_runs([RunRequest(str(self.folder / "world.xml"), (), seed) for seed in range(1, SEEDS + 1)])
        self.assertEqual(len(made), SEEDS)
        for outcome in made:
            self.assertGreater(outcome.wall_s, 0)
        return ({seed: outcome.failure for seed, outcome in enumerate(made, 1) if outcome.failure},
                {seed: outcome.state_hash for seed, outcome in enumerate(made, 1) if not outcome.failure})

    def test_each_is_an_outcome_of_its_seed_and_the_others_go_on(self):
        _, expected = self.make("pass")
        self.assertEqual(len(expected), SEEDS)
        bad = set(self.make("raise KeyboardInterrupt")[0])
        self.assertTrue(BAD <= len(bad) < SEEDS, bad)
        for action, message in ACTIONS.items():
            with self.subTest(action):
                failures, states = self.make(action)
                self.assertEqual(failures, dict.fromkeys(bad, message))
                self.assertEqual(states, {seed: state for seed, state in expected.items() if seed not in bad})

    def test_signals_to_its_group_and_an_ignored_interrupt_reach_no_other_process(self):
        for action in ("os.kill(0, signal.SIGINT)", "signal.raise_signal(signal.SIGINT)"):
            with self.subTest(action):
                self.assertEqual(self.make(action)[0], {})

    def test_what_a_run_has_started_ends_with_it(self):
        self.make("subprocess.Popen(['sleep', '617'], close_fds=False); os.abort()")
        end = time.monotonic() + 10
        while [one for one in psutil.process_iter(["cmdline"]) if one.info["cmdline"] == ["sleep", "617"]]:
            self.assertLess(time.monotonic(), end, "it goes on")
            time.sleep(0.05)

    def start_endless(self):
        """@return a batch whose run never releases the GIL, and its workers"""
        self.write(f"open({str(self.folder / 'begun')!r}, 'w').close(); re.match('(a+)+$', 'a' * 60 + 'b')", chance=2)
        program = self.start("batch", "world.xml", "--seeds", "1", "--jobs", 1, "--quiet", "--no-report", "--force",
                             start_new_session=True)
        self.wait_for_lines("begun", 0, program)
        workers = workers_of(program)
        self.addCleanup(self.end, workers)
        self.assertEqual(len(workers), 2)
        return program, workers

    def end(self, processes):
        """Kills processes that a failed test has left."""
        for process in processes:
            with contextlib.suppress(psutil.NoSuchProcess):
                process.kill()

    def test_a_run_that_never_gives_the_lock_of_python_back_ends_with_the_program(self):
        program, _ = self.start_endless()
        self.kill(program)
        (self.folder / "begun").unlink()
        program, workers = self.start_endless()
        os.killpg(program.pid, signal.SIGINT)
        program.communicate(timeout=PATIENCE_S)
        self.assertEqual(program.returncode, INTERRUPTED)
        self.assertEqual(psutil.wait_procs(workers, timeout=20)[1], [], "workers outlive the program")

    def test_a_run_that_never_gives_the_lock_of_python_back_ends_with_its_worker(self):
        program, (worker, maker) = self.start_endless()
        worker.kill()
        self.assertEqual(psutil.wait_procs([maker], timeout=20)[1], [], "it outlives its worker")
        self.kill(program)

    def test_a_long_text_of_a_failure_is_cut_and_its_batch_goes_on(self):
        self.write("raise ValueError('x' * 200_000)", chance=2)
        options = ("--jobs", 1, "--quiet")
        self.call("batch", "world.xml", "--seeds", "1..2", *options, code=CONTROLLER_FAILED)
        with open(self.folder / "world.csv", newline="") as file:
            failures = [row["failure"] for row in csv.DictReader(file)]
        self.assertEqual([len(failure) for failure in failures], [MOST_FAILURE] * 2)
        self.assertRegex(failures[0], r"^1 controllers failed, first fb in tick 2: .*ValueError: x+$")
        summary = self.call("batch", "world.xml", "--seeds", "1..3", *options, "--resume", code=CONTROLLER_FAILED)
        self.assertEqual((summary["made"], summary["missing"]), (1, 0))
        self.assertEqual(self.call("report", "world.csv"), "world.html\n")

    def test_a_batch_has_a_row_of_each(self):
        self.write("os.abort()")
        program = self.start("batch", "world.xml", "--seeds", f"1..{SEEDS}", "--jobs", 2, "--quiet", "--no-report")
        output, errors = program.communicate(timeout=PATIENCE_S)
        with open(self.folder / "world.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual(sorted(int(row["seed"]) for row in rows), list(range(1, SEEDS + 1)))
        failures = [row["failure"] for row in rows if row["failure"]]
        self.assertEqual(set(failures), {TRIED + "by SIGABRT"})
        self.assertEqual([row for row in rows if not float(row["wall_s"])], [])
        self.assertEqual((program.returncode, errors, json.loads(output)["incomplete"]), (STOPPED, "", len(failures)))

    def test_processes_that_cannot_begin_are_reported(self):
        makers.stop()
        with mock.patch.object(makers, "MAIN", "import os; os._exit(3)"), self.assertRaises(RunsStopped) as caught:
            makers.make_runs([RunRequest("phototaxis", (), 1)])
        self.assertEqual(str(caught.exception), "processes that make runs cannot be started: 10 ended as they began, the last one with "
                         "exit code 3")

    def test_a_library_that_is_missing_is_named(self):
        makers.stop()
        begin = "import sys; sys.modules['swarmanoid'] = None; " + makers.MAIN
        with mock.patch.object(makers, "MAIN", begin), self.assertRaises(RunsStopped) as caught:
            makers.make_runs([RunRequest("phototaxis", (), 1)])
        self.assertEqual(str(caught.exception), "a process that makes runs cannot be started: ModuleNotFoundError: import of swarmanoid "
                         "halted; None in sys.modules")
        self.assertIsNone(makers._maker)

    def test_a_process_that_was_interrupted_as_it_answered_is_not_used_again(self):
        self.write("robot.commands['footbot_wheels'].left = robot.uniform()", chance=2)
        makers.stop()
        self.addCleanup(makers.stop)
        request = RunRequest(str(self.folder / "world.xml"), (), 1)
        whole, other = makers.make_runs([request, request._replace(seed=2)])
        self.assertEqual((whole.failure, other.failure), ("", ""))
        self.assertNotEqual(other.state_hash, whole.state_hash)
        with mock.patch.object(makers._Maker, "_receive", side_effect=KeyboardInterrupt), self.assertRaises(KeyboardInterrupt):
            makers.make_runs([request._replace(seed=2)])
        again, = makers.make_runs([request])
        self.assertEqual(again.state_hash, whole.state_hash)

    def test_a_worker_begins_though_the_system_refuses_a_process(self):
        makers.stop()
        self.addCleanup(signal.signal, signal.SIGINT, signal.getsignal(signal.SIGINT))
        with mock.patch.object(makers, "_Maker", side_effect=OSError(errno.EMFILE, os.strerror(errno.EMFILE))):
            worker_setup.set_up()
            with self.assertRaises(RunsStopped) as caught:
                makers.make_runs([RunRequest("phototaxis", (), 1)])
        self.assertEqual(str(caught.exception), "a process that makes runs cannot be started: Too many open files")


if __name__ == "__main__":
    unittest.main()

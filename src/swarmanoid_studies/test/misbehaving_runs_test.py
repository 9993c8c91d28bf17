#!/usr/bin/python3
"""Controllers that end or harm their process with some seeds: these are rows that say so, and all others are made."""

import csv
import json
import time
import unittest
from unittest import mock

import psutil
from commands import PATIENCE_S, SCRIPTED, STOPPED, CommandsTest
from swarmanoid_studies import makers
from swarmanoid_studies.mistakes import RunsStopped
from swarmanoid_studies.runs import RunRequest

SEEDS, BAD = 8, 1   # so many seeds at least are bad; what the robot draws says which
SCRIPT = """import os, signal, subprocess, time

class Drive:
    def step(self, robot):
        if robot.tick == 2 and robot.uniform() < 0.3:
            %s
"""
TRIED = "the process that made the run ended in it, each of 3 times, "
# what a controller does, and what its row says
DEEDS = {
    "os.abort()": TRIED + "by SIGABRT",
    "os._exit(0)": TRIED + "with exit code 0",
    "os.closerange(0, 65536)": TRIED + "with exit code 1",
    "os.closerange(3, 65536); time.sleep(600)": TRIED + "it closed its connection",
    "os.kill(os.getpid(), signal.SIGKILL)": TRIED + "by SIGKILL",
    "signal.signal(signal.SIGINT, signal.SIG_DFL); os.kill(0, signal.SIGINT)": TRIED + "by SIGINT",
    "subprocess.Popen(['sleep', '600'], close_fds=False); os.abort()": TRIED + "by SIGABRT",
}


class MisbehavingRunsTest(CommandsTest):
    def write(self, deed):
        (self.folder / "world.xml").write_text(SCRIPTED.replace("400", "9"))
        (self.folder / "drive.py").write_text(SCRIPT % deed)

    def make(self, deed):
        """@return failures by seed, and the state of the other runs by seed"""
        self.write(deed)
        self.addCleanup(makers.stop)
        makers.stop()   # the next one reads the script anew
        made = makers.make_runs([RunRequest(str(self.folder / "world.xml"), (), seed) for seed in range(1, SEEDS + 1)])
        self.assertEqual(len(made), SEEDS)
        return ({seed: outcome.failure for seed, outcome in enumerate(made, 1) if outcome.failure},
                {seed: outcome.state_hash for seed, outcome in enumerate(made, 1) if not outcome.failure})

    def test_each_is_an_outcome_of_its_seed_and_the_others_go_on(self):
        _, expected = self.make("pass")
        self.assertEqual(len(expected), SEEDS)
        bad = set(self.make("raise KeyboardInterrupt")[0])
        self.assertTrue(BAD <= len(bad) < SEEDS, bad)
        for deed, message in DEEDS.items():
            with self.subTest(deed):
                failures, states = self.make(deed)
                self.assertEqual(failures, dict.fromkeys(bad, message))
                self.assertEqual(states, {seed: state for seed, state in expected.items() if seed not in bad})

    def test_signals_to_its_group_and_an_ignored_interrupt_reach_no_other_process(self):
        for deed in ("os.kill(0, signal.SIGINT)", "signal.raise_signal(signal.SIGINT)"):
            with self.subTest(deed):
                self.assertEqual(self.make(deed)[0], {})

    def test_what_a_run_has_started_ends_with_it(self):
        self.make("subprocess.Popen(['sleep', '617'], close_fds=False); os.abort()")
        end = time.monotonic() + 10
        while [one for one in psutil.process_iter(["cmdline"]) if one.info["cmdline"] == ["sleep", "617"]]:
            self.assertLess(time.monotonic(), end, "it goes on")
            time.sleep(0.05)

    def test_a_batch_has_a_row_of_each(self):
        self.write("os.abort()")
        program = self.start("batch", "world.xml", "--seeds", f"1..{SEEDS}", "--jobs", 2, "--quiet", "--no-report")
        output, errors = program.communicate(timeout=PATIENCE_S)
        with open(self.folder / "world.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual(sorted(int(row["seed"]) for row in rows), list(range(1, SEEDS + 1)))
        failures = [row["failure"] for row in rows if row["failure"]]
        self.assertEqual(set(failures), {TRIED + "by SIGABRT"})
        self.assertEqual((program.returncode, errors, json.loads(output)["incomplete"]), (STOPPED, "", len(failures)))

    def test_processes_that_cannot_begin_are_told(self):
        makers.stop()
        with mock.patch.object(makers, "MAIN", "import os; os._exit(3)"), self.assertRaises(RunsStopped) as caught:
            makers.make_runs([RunRequest("phototaxis", (), 1)])
        self.assertEqual(str(caught.exception), "processes that make runs cannot be started: 10 ended as they began, the last one with "
                         "exit code 3")


if __name__ == "__main__":
    unittest.main()

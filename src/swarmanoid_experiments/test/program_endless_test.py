#!/usr/bin/python3
"""The program with controllers whose calls do not return: signals and the watchdog end them, and files and summary
are saved."""

import fcntl
import json
import os
import pathlib
import signal
import subprocess
import time
import unittest

from misbehaving_program import TIMEOUT, MisbehavingTest
from misbehaving_world import NAME, world
from program_world import BAD_INPUT, CONTROLLER_FAILED, FINISHED, INTERRUPTED


class EndlessTest(MisbehavingTest):
    def test_the_second_signal_ends_it(self):
        for number in (signal.SIGINT, signal.SIGTERM):
            for action in ("loop", "loop_deaf", "sleep_for_ever", "wait_for_itself"):
                with self.subTest(number=number, action=action):
                    process = self.start("step", action, "--bag", "run.bag")
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
        os.write(theirs, size * b" ")  # the summary blocks until this is read
        with open(ours, encoding="utf-8") as output, subprocess.Popen(
                ["swarmanoid", "run", "world.xml", "--quiet", "--force", "--watchdog", "6", "--hashes", "hashes.txt"],
                cwd=self.folder, stdout=theirs, stderr=subprocess.PIPE, encoding="utf-8") as process:
            os.close(theirs)
            self.read_until(process, f"watchdog: more than 6 s in step of {NAME}, tick 3")
            time.sleep(3.0)  # the call returns after one second
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
        script = "swarmanoid validate world.xml --end-with-parent & echo $!; exec sleep 60"
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


if __name__ == "__main__":
    unittest.main(argv=[pathlib.Path(__file__).name, "-v"])

#!/usr/bin/python3
"""The program `swarmanoid batch`: the same rows with any workers, also if processes are killed."""

import contextlib
import csv
import json
import os
import random
import resource
import signal
import socket
import subprocess
import time
import unittest

import psutil
from commands import BAD_INPUT, CONTROLLER_FAILED, FINISHED, INTERRUPTED, PATIENCE_S, SCRIPTED, STOPPED, CommandsTest, workers_of

EXPERIMENT = "phototaxis"
SPEED = "controllers.pc.parameters.speed"
TICKS = "801"
GRID = (EXPERIMENT, "--seeds", "1..40", "--set", f"{SPEED}=0.05,0.1,0.2", "--ticks", TICKS, "--no-report")
RUNS = 120
FAILS = """<ahss-config>
  <framework><clocktick>100</clocktick><maxclock>20</maxclock></framework>
  <controllers>
    <phototaxis id="pc" library="phototaxis">
      <actuators><footbot_wheels/></actuators><sensors><footbot_proximity/><light/></sensors>
      <parameters><speed>0.1</speed></parameters>
    </phototaxis>
  </controllers>
  <arena size="3,3,2" optimization="2D" bounded="true">
    <footbot id="fb"><position>1, 1, 0</position><orientation>0, 0, 0</orientation><controller>pc</controller></footbot>
  </arena>
  <engines><kinematics2d id="ground"/></engines>
  <arena_physics><engine id="ground"><entity id="fb"/></engine></arena_physics>
</ahss-config>
"""

SCRIPT = """import speeds

class Drive:
    def step(self, robots):
        robots.commands["footbot_wheels"].left = robots.commands["footbot_wheels"].right = speeds.SPEED
"""


class BatchTest(CommandsTest):
    whole = []  # rows of the grid, made once

    def uninterrupted(self):
        if not self.whole:
            self.call("batch", *GRID, "--jobs", 2, "--out", "whole.csv", "--quiet")
            self.whole.extend(self.rows("whole.csv"))
        return self.whole

    def hashes(self, name):
        """Hashes of the last states, by row."""
        with open(self.folder / name, newline="") as file:
            return [row["state_hash"] for row in csv.DictReader(file)]

    def test_rows_are_those_of_the_program_and_of_any_number_of_jobs(self):
        expected = self.uninterrupted()
        self.assertEqual(len(set(expected)), RUNS)
        summary = self.call("batch", *GRID, "--jobs", 1, "--out", "one.csv", "--quiet")
        self.assertEqual(self.rows("one.csv"), expected)
        self.assertEqual((summary["runs"], summary["made"], summary["missing"]), (RUNS, RUNS, 0))
        done = subprocess.run(["swarmanoid", "run", EXPERIMENT, "--seed", "17", "--set", f"{SPEED}=0.2", "--set",
                               f"framework.maxclock={TICKS}", "--quiet"],
                              cwd=self.folder, stdout=subprocess.PIPE, check=True, text=True)
        single = json.loads(done.stdout)
        row, = (row for row in expected if row[4:6] == ("0.2", "17"))
        self.assertEqual(row[:3], (EXPERIMENT, single["version"], single["math_library"]))
        self.assertIn(single["state_hash"], row)
        overrides, = (json.loads(value) for value in row if value.startswith("["))
        self.assertEqual(set(overrides), {f"{SPEED}=0.2", f"framework.maxclock={TICKS}"})
        self.assertIn(repr(single["metrics"]["lamps.distance"]), row)

    def test_killed_processes_do_not_change_the_rows(self):
        chance = random.Random(int(time.time()))
        expected = self.uninterrupted()
        options = ("--jobs", "2", "--out", "killed.csv", "--quiet")
        # kills a worker: others take over its runs
        program = self.start("batch", *GRID, *options)
        self.wait_for_lines("killed.csv", chance.randint(5, 60), program)
        chance.choice(workers_of(program)).kill()
        # kills the program itself, and then once more: its rows so far are kept
        self.wait_for_lines("killed.csv", chance.randint(62, 75), program)
        self.kill(program)
        for least in (chance.randint(80, 90), chance.randint(95, 105)):
            program = self.start("batch", *GRID, *options, "--resume")
            self.wait_for_lines("killed.csv", least, program)
            self.kill(program)
        summary = self.call("batch", *GRID, *options, "--resume")
        self.assertLess(summary["made"], RUNS - 90)
        self.assertEqual(self.rows("killed.csv"), expected)

    def test_a_worker_that_is_killed_as_it_starts_is_replaced(self):
        chance = random.Random(int(time.time()))
        program = self.start("batch", *GRID, "--jobs", "2", "--out", "killed.csv", "--quiet")
        end = time.monotonic() + PATIENCE_S
        while not workers_of(program):
            self.assertLess(time.monotonic(), end, "no process makes runs")
            time.sleep(0.01)
        for _ in range(2):
            time.sleep(chance.uniform(0.0, 1.0))
            for worker in workers_of(program)[:1]:
                worker.kill()
        output, errors = program.communicate(timeout=PATIENCE_S)
        self.assertEqual((program.returncode, errors), (FINISHED, ""))
        self.assertEqual(json.loads(output)["made"], RUNS)
        self.assertEqual(self.rows("killed.csv"), self.uninterrupted())

    def test_a_worker_that_cannot_be_started_again_ends_the_batch_and_rows_are_kept(self):
        options = ("--jobs", "2", "--out", "stopped.csv", "--quiet")
        program = self.start("batch", *GRID, *options)
        self.wait_for_lines("stopped.csv", 10, program)
        workers = workers_of(program)
        resource.prlimit(program.pid, resource.RLIMIT_NOFILE, (3, 3))  # no further files
        workers[0].kill()
        output, errors = program.communicate(timeout=PATIENCE_S)
        self.assertEqual(errors, "swarmanoid: process 2 of 2 that makes runs cannot be started: Too many open files\n")
        self.assertEqual((program.returncode, output), (STOPPED, ""))
        self.assertEqual(psutil.wait_procs(workers, timeout=20)[1], [], "workers outlive the program")
        self.assertLess(self.call("batch", *GRID, *options, "--resume")["made"], RUNS - 8)
        self.assertEqual(self.rows("stopped.csv"), self.uninterrupted())

    def test_a_file_that_changes_ends_the_batch_and_rows_are_of_what_it_was(self):
        files = {"world.xml": SCRIPTED, "drive.py": SCRIPT, "speeds.py": "SPEED = 2.0\n"}
        changes = {"world.xml": ("400", "500"), "drive.py": ("= speeds", "= 1.1 * speeds"), "speeds.py": ("2.0", "3.0")}
        for name, text in files.items():
            (self.folder / name).write_text(text)
        self.call("batch", "world.xml", "--seeds", "1", "--out", "one.csv", "--quiet", "--no-report")
        expected = self.hashes("one.csv")
        for changed, (old, new) in changes.items():
            with self.subTest(changed):
                for name, text in files.items():
                    (self.folder / name).write_text(text)
                out = f"{changed}.csv"
                program = self.start("batch", "world.xml", "--seeds", "1..5000", "--jobs", "2", "--out", out, "--quiet", "--no-report")
                self.wait_for_lines(out, 20, program)
                (self.folder / changed).write_text(files[changed].replace(old, new))
                output, errors = program.communicate(timeout=PATIENCE_S)
                name = "the experiment file" if changed == "world.xml" else changed
                self.assertEqual(errors, f"swarmanoid: {name} has changed since the runs began; rows so far are of what it was\n")
                self.assertEqual((program.returncode, output), (STOPPED, ""))
                self.assertGreater(len(self.hashes(out)), 10)
                self.assertEqual(set(self.hashes(out)), set(expected))

    def test_an_interrupt_keeps_what_is_done(self):
        program = self.start("batch", *GRID, "--jobs", "2", "--out", "runs.csv", "--quiet", start_new_session=True)
        self.wait_for_lines("runs.csv", 10, program)
        workers = workers_of(program)
        self.assertEqual(len(workers), 4)
        os.killpg(program.pid, signal.SIGINT)  # as Ctrl-C in a terminal
        output, errors = program.communicate(timeout=60)
        self.assertEqual(psutil.wait_procs(workers, timeout=20)[1], [], "workers outlive the program")
        self.assertEqual((program.returncode, errors), (INTERRUPTED, "swarmanoid: interrupted; --resume goes on\n"))
        summary = json.loads(output)
        self.assertEqual(summary["made"], len(self.rows("runs.csv")))
        self.assertEqual(summary["made"] + summary["missing"], RUNS)

    def test_millions_of_runs_begin_at_once_and_take_no_memory(self):
        program = self.start("batch", EXPERIMENT, "--seeds", "1..9999999", "--ticks", 3, "--jobs", 1, "--out", "runs.csv", "--quiet",
                             "--no-report", start_new_session=True)
        self.wait_for_lines("runs.csv", 50, program)
        self.assertLess(psutil.Process(program.pid).memory_info().rss, 400e6)
        os.killpg(program.pid, signal.SIGINT)
        output, _ = program.communicate(timeout=60)
        self.assertEqual((program.returncode, json.loads(output)["runs"]), (INTERRUPTED, 9999999))

    def test_a_full_output_and_a_full_file_are_reported_by_name(self):
        limited = {"preexec_fn": lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (3000, 3000))}
        program = self.start("batch", EXPERIMENT, "--seeds", "1..200", "--ticks", 3, "--jobs", 1, "--out", "runs.csv", "--quiet",
                             "--no-report", **limited)
        self.assertEqual(program.communicate(timeout=PATIENCE_S), ("", "swarmanoid: runs.csv: cannot be written: File too large\n"))
        self.assertEqual(program.returncode, STOPPED)
        self.assertTrue((self.folder / "runs.csv").read_bytes().endswith(b"\n"))
        program = self.start("report", "runs.csv", **limited)
        self.assertEqual(program.communicate(timeout=PATIENCE_S), ("", "swarmanoid: runs.html: cannot be written: File too large\n"))
        with open("/dev/full", "w") as full:
            done = subprocess.run(["swarmanoid", "report", "runs.csv"], cwd=self.folder, stdout=full, stderr=subprocess.PIPE, text=True)
        self.assertEqual((done.returncode, done.stderr),
                         (STOPPED, "swarmanoid: standard output: cannot be written: No space left on device\n"))

    def test_the_port_of_a_dashboard_may_be_taken(self):
        with socket.socket() as other:
            with contextlib.suppress(OSError):  # another program uses it
                other.bind(("127.0.0.1", 8787))
                other.listen()
            program = self.start("batch", EXPERIMENT, "--seeds", "1", "--ticks", 5, "--jobs", "1", "--quiet")
            _, errors = program.communicate(timeout=PATIENCE_S)
        self.assertEqual((program.returncode, errors), (FINISHED, ""))

    def test_a_report_has_distributions_and_pairs_by_seed(self):
        self.call("batch", EXPERIMENT, "--seeds", "1..6", "--set", f"{SPEED}=0.1,0.2", "--ticks", 900, "--quiet")
        text = (self.folder / "phototaxis.html").read_text()
        for part in ("<h1>phototaxis: 12 runs, 6 seeds</h1>", f"<h2>lamps.distance by {SPEED}</h2>", "data:image/png;base64,",
                     "effect size d_z", "Wilcoxon p"):
            self.assertIn(part, text)
        self.assertEqual(self.call("report", "phototaxis.csv", "--out", "runs.png"), "runs.png\n")
        self.assertEqual((self.folder / "runs.png").read_bytes()[:4], b"\x89PNG")

    def test_runs_that_fail_are_rows_and_the_exit_code_says_it(self):
        library = "failing_controller"
        text = FAILS.replace("phototaxis", library).replace("<sensors><footbot_proximity/><light/></sensors>", "")
        text = text.replace("<speed>0.1</speed>", "<fail_at>-1</fail_at>")
        (self.folder / "fails.xml").write_text(text)
        summary = self.call("batch", "fails.xml", "--seeds", "1,2", "--set", "controllers.pc.parameters.fail_at=-1,3",
                            "--jobs", 1, "--quiet", code=CONTROLLER_FAILED)
        self.assertEqual((summary["controllers_failed"], summary["incomplete"]), (2, 0))
        failed = [row for row in self.rows("fails.csv") if any("controllers failed" in value for value in row)]
        self.assertEqual([row[4:6] for row in failed], [("3", "1"), ("3", "2")])
        self.assertIn("Runs that failed: 2", (self.folder / "fails.html").read_text())

    def test_bad_input_is_reported_in_one_line_and_leaves_nothing_behind(self):
        for message, *arguments in (
                ("the following arguments are required: --seeds; `swarmanoid batch --help` has all options", EXPERIMENT),
                ("--seeds: found '9..1', allowed: seeds and ranges of seeds, such as 1..1000 or 1,2,10..20", EXPERIMENT,
                 "--seeds", "9..1"),
                ("--jobs: found 0, allowed: 1 to 1024", EXPERIMENT, "--seeds", "1", "--jobs", "0"),
                ("found --jobs and --scheduler, allowed: one of them", EXPERIMENT, "--seeds", "1", "--jobs", "1", "--scheduler",
                 "tcp://localhost:1"),
                ("--scheduler: found 'ucx://localhost:1', allowed: tcp://host:port, or tls://host:port with certificates in Dask's "
                 "configuration", EXPERIMENT, "--seeds", "1", "--scheduler", "ucx://localhost:1"),
                ("/nope/x.html: cannot be written: No such file or directory", EXPERIMENT, "--seeds", "1", "--report", "/nope/x.html"),
                ("no.pdf: found another ending, allowed: .html or .png", EXPERIMENT, "--seeds", "1", "--report", "no.pdf"),
                ("nowhere/runs.csv: cannot be written: No such file or directory", EXPERIMENT, "--seeds", "1", "--out",
                 "nowhere/runs.csv"),
                ("runs.csv: cannot be continued: No such file or directory", EXPERIMENT, "--seeds", "1", "--out", "runs.csv",
                 "--resume")):
            with self.subTest(message):
                self.assert_refused(message, "batch", *arguments)
        self.assert_refused("nothing.csv: cannot be read: No such file or directory", "report", "nothing.csv")

    def test_a_file_is_replaced_only_when_its_workers_are_there(self):
        (self.folder / "runs.csv").write_text("made in three weeks\n")
        program = self.start("batch", EXPERIMENT, "--seeds", "1", "--out", "runs.csv", "--force", "--scheduler", "tcp://127.0.0.1:1")
        output, errors = program.communicate(timeout=PATIENCE_S)
        self.assertEqual((program.returncode, output), (BAD_INPUT, ""))
        self.assertRegex(errors, r"^swarmanoid: --scheduler: found 'tcp://127.0.0.1:1', allowed: the address of a dask-scheduler .*\n$")
        self.assertEqual((self.folder / "runs.csv").read_text(), "made in three weeks\n")

    def test_values_are_tried_before_anything_runs(self):
        program = self.start("batch", EXPERIMENT, "--seeds", "1", "--set", f"{SPEED}=0.1,7")
        _, errors = program.communicate(timeout=60)
        self.assertEqual(program.returncode, 2)
        self.assertRegex(errors, f"^swarmanoid: --set {SPEED}: .*found '?7'?, allowed: .*\n$")
        self.assertEqual(list(self.folder.iterdir()), [])


class ProgramTest(CommandsTest):
    def test_help_lists_commands_of_other_packages(self):
        text = self.call("--help")
        self.assertRegex(text, "batch +runs an experiment with many seeds and values")
        self.assertIn("usage: swarmanoid report", self.call("report", "--help"))

    def test_any_program_on_the_path_is_a_command(self):
        own = self.folder / "swarmanoid-greet"
        own.write_text('#!/bin/sh\n# summary: greets\necho "hello $*"; exit 3\n')
        own.chmod(0o755)
        environment = dict(os.environ, PATH=f"{self.folder}:{os.environ['PATH']}")
        program = self.start("greet", "--a", "b c", env=environment)
        self.assertEqual((*program.communicate(timeout=20), program.returncode), ("hello --a b c\n", "", 3))
        program = self.start("--help", env=environment)
        self.assertRegex(program.communicate(timeout=20)[0], "greet +greets")


if __name__ == "__main__":
    unittest.main()

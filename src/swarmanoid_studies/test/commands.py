"""Shared parts of the tests of the programs: a folder per test, calls of programs, and killing of processes."""

import csv
import json
import pathlib
import signal
import subprocess
import tempfile
import time
import unittest

import psutil

FINISHED, BAD_INPUT, CONTROLLER_FAILED, STOPPED, INTERRUPTED = 0, 2, 3, 4, 130
PATIENCE_S = 120
# one robot, with its controller in drive.py
SCRIPTED = """<ahss-config>
  <framework><clocktick>100</clocktick><maxclock>400</maxclock></framework>
  <controllers>
    <Drive id="drive" source="python" file="drive.py"><actuators><footbot_wheels/></actuators></Drive>
  </controllers>
  <arena size="9,9,2" optimization="2D"><footbot id="fb"><position>1, 1, 0</position><controller>drive</controller></footbot></arena>
  <engines><kinematics2d id="ground"/></engines>
  <arena_physics><engine id="ground"><entity id="fb"/></engine></arena_physics>
</ahss-config>
"""


class CommandsTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def start(self, *arguments, **options):
        return subprocess.Popen(["swarmanoid", *map(str, arguments)], cwd=self.folder, stdout=subprocess.PIPE,
                                stderr=subprocess.PIPE, stdin=subprocess.DEVNULL, text=True, **options)

    def call(self, *arguments, code=FINISHED):
        """Runs the program to its end. @return its summary, or its output if that is no summary"""
        program = self.start(*arguments)
        output, errors = program.communicate(timeout=PATIENCE_S)
        self.assertEqual(program.returncode, code, errors)
        return json.loads(output) if output.startswith("{") else output

    def assert_refused(self, message, *arguments):
        """Expects this message in one line, and no new files."""
        before = sorted(self.folder.rglob("*"))
        program = self.start(*arguments)
        output, errors = program.communicate(timeout=PATIENCE_S)
        self.assertEqual((program.returncode, output, errors), (BAD_INPUT, "", f"swarmanoid: {message}\n"))
        self.assertEqual(sorted(self.folder.rglob("*")), before)

    def rows(self, name):
        """Rows of a CSV file without wall time, sorted by run."""
        with open(self.folder / name, newline="") as file:
            rows = list(csv.reader(file))
        head = rows[0]
        wall = head.index("wall_s")
        return sorted(tuple(value for i, value in enumerate(row) if i != wall) for row in rows[1:])

    def wait_for_lines(self, name, lines, program):
        """Waits until a file has that many lines."""
        end = time.monotonic() + PATIENCE_S
        path = self.folder / name
        while not path.exists() or path.read_bytes().count(b"\n") < lines:
            self.assertIsNone(program.poll(), "the program has ended")
            self.assertLess(time.monotonic(), end, "no rows come")
            time.sleep(0.01)

    def kill(self, program):
        """Sends SIGKILL, and waits until the program's child processes have ended."""
        workers = workers_of(program)
        program.send_signal(signal.SIGKILL)
        program.communicate(timeout=PATIENCE_S)
        _, alive = psutil.wait_procs(workers, timeout=20)
        self.assertEqual(alive, [], "workers outlive the program")


def workers_of(program):
    """Processes that make runs for a program: workers and their makers."""
    return [child for child in psutil.Process(program.pid).children(recursive=True)
            if any("spawn_main" in word or "maker_process" in word for word in command_of(child))]


def command_of(process):
    try:
        return process.cmdline()
    except psutil.NoSuchProcess:
        return []

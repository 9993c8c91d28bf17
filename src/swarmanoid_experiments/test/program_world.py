"""Shared by the tests of the program `swarmanoid`: a small experiment, and functions that run the program on it."""

import json
import os
import pathlib
import subprocess
import tempfile
import unittest

import rosbag

WORLD = """<ahss-config>
  <framework><clocktick>100</clocktick><maxclock>{maxclock}</maxclock></framework>
  <controllers>
    <failing_controller id="fc" library="failing_controller">
      <actuators><footbot_wheels/></actuators>
      <parameters><fail_at>{fail_at}</fail_at></parameters>
    </failing_controller>
  </controllers>
  <arena size="10,10,3" optimization="2D">
    <footbot id="fb"><position>2, 3, 0</position><orientation>0, 0, 90</orientation><controller>fc</controller></footbot>
    <block id="wall"><position>5, 5, 0.25</position><orientation>0, 0, 45</orientation><size>1, 0.1, 0.5</size></block>
  </arena>
  <engines><kinematics2d id="ground"/></engines>
  <arena_physics><engine id="ground"><entity id="fb"/><entity id="wall"/></engine></arena_physics>
  <visualisations>{visualisations}</visualisations>
</ahss-config>
"""

TABLE = '<text_render id="table"><file>table.txt</file></text_render>'
HEADER = "#clock\tEntity type\tEntity id\tX\tY\tZ\tAlpha\tBeta\tGamma\n"

def table_of(file, test):
    """@return lines between the first one, which identifies the run of a table, and the last one, which describes its end"""
    first, *lines, last = file.read_text().splitlines(keepends=True)
    test.assertRegex(first, r"^# \w+, seed \d+, swarmanoid [0-9.]+(\+[0-9a-f]+(\.dirty)?)?\n$")
    test.assertRegex(last, r"^# ended after \d+ ticks, state hash [0-9a-f]{16}\n$")
    return "".join(lines)


FINISHED, BAD_INPUT, CONTROLLER_FAILED, STOPPED, INTERRUPTED = 0, 2, 3, 4, 130


class ProgramTest(unittest.TestCase):
    """Each test has its own folder."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.out = self.folder / "out"

    def world(self, maxclock=20, fail_at=-1, visualisations=TABLE, text=WORLD):
        """Writes the small experiment. @return path of its file"""
        file = self.folder / "world.xml"
        file.write_text(text.format(maxclock=maxclock, fail_at=fail_at, visualisations=visualisations))
        return str(file)

    def put_before_prefixes(self):
        """Makes the test's folder a prefix, like a user's sourced workspace."""
        path = os.environ["CMAKE_PREFIX_PATH"]
        self.addCleanup(os.environ.__setitem__, "CMAKE_PREFIX_PATH", path)
        os.environ["CMAKE_PREFIX_PATH"] = f"{self.folder}:{path}"

    def call(self, *arguments):
        """Runs the program to its end."""
        return subprocess.run(["swarmanoid", *map(str, arguments)], cwd=self.folder, timeout=60,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, encoding="utf-8", errors="replace",
                              check=False)

    def run_world(self, *arguments, code=FINISHED, **world):
        """`run` on the small experiment; can be repeated. @return its summary"""
        done = self.call("run", self.world(**world), "--quiet", "--force", "--out", self.out, *arguments)
        self.assertEqual(done.returncode, code, done.stderr)
        self.assertEqual(done.stdout.count("\n"), 1, "one line on standard output")
        return json.loads(done.stdout)

    def ticks_in(self, bag):
        """Returns the ticks of the states in a bag."""
        with rosbag.Bag(str(bag)) as opened:
            return [message.tick for _, message, _ in opened.read_messages("/space/world_state")]

    def assert_refused(self, message, *arguments):
        """Expects this message in one line, no summary, and no new files."""
        before = sorted(self.folder.rglob("*"))
        done = self.call(*arguments)
        self.assertEqual(done.returncode, BAD_INPUT, done.stderr)
        self.assertEqual(done.stdout, "")
        self.assertEqual(done.stderr, "swarmanoid: " + message + "\n")
        self.assertEqual(sorted(self.folder.rglob("*")), before)

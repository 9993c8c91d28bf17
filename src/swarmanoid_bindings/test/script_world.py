"""Shared parts of the tests of scripts that an experiment names: an experiment, its script, and calls of the program."""

import csv
import pathlib
import subprocess
import tempfile
import unittest

EXPERIMENT = """<?xml version="1.0"?>
<ahss-config>
  <framework><clocktick>100</clocktick><maxclock>60</maxclock><random_seed>5</random_seed></framework>
  <controllers>
    <{controller} id="dc" source="python" file="swarm.py">
      <actuators><footbot_wheels><noise>0.05</noise></footbot_wheels></actuators>
      <sensors><footbot_proximity/></sensors>
      <parameters><speed>3.5</speed></parameters>
    </{controller}>
  </controllers>
  <arena size="3,3,1" optimization="2D" bounded="true">
    <distribute quantity="9">
      <minimum>0.3, 0.3, 0</minimum>
      <maximum>2.7, 2.7, 0</maximum>
      <footbot id="fb"><controller>dc</controller></footbot>
    </distribute>
  </arena>
  <engines><kinematics2d id="ground"/></engines>
  <arena_physics><engine id="ground"><entity id="fb"/></engine></arena_physics>
  <rules><{rule} id="count" source="python" file="swarm.py"><limit>0.9</limit></{rule}></rules>
</ahss-config>
"""

SWARM = """
import beside
import numpy

calls = 0


class All:
    def init(self, parameters):
        self.speed = float(parameters["speed"])

    def step(self, robots):
        near = robots.readings["footbot_proximity"].value.max(axis=1) > beside.NEAR
        wheels = robots.commands["footbot_wheels"]
        wheels.left = numpy.where(near, -self.speed, self.speed + robots.uniform(-1, 1))
        wheels.right = self.speed


class One:
    def init(self, robot, parameters):
        self.speed = float(parameters["speed"])

    def step(self, robot):
        robot.commands["footbot_wheels"].right = self.speed * robot.uniform()


class Count:
    def init(self, parameters):
        self.limit = float(parameters["limit"])
        self.seen = 0

    def after_tick(self, world):
        global calls
        calls += 1
        self.seen += int((world.robots.poses[:, 0] < self.limit).sum())

    def metrics(self):
        return {"seen": self.seen, "calls": calls}


def breaks(robots):
    if robots.tick == 20:
        print("said by Python")
        1 / 0


def leaves(robots):
    raise SystemExit(7)


class Broken:
    def after_tick(self, world):
        raise RuntimeError("no more")


class Refuses:
    def init(self, parameters):
        raise ValueError("found speed " + parameters["speed"] + ", allowed: 4")

    def step(self, robots):
        pass


def remembers(robots):
    global calls
    calls += 1
    robots.commands["footbot_wheels"].left = calls % 7


class Instances:
    def __init__(self):
        self.seen = 0

    def after_tick(self, world):
        self.seen += 1

    def metrics(self):
        return {"seen": self.seen}


together = All()
refuses = Refuses()
number = 3
count = Count()
"""


class ScriptCase(unittest.TestCase):
    """Gives each test its own folder with these files."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.write("beside.py", "NEAR = 0.02\n")
        self.write("swarm.py", SWARM)

    def write(self, name, text):
        (self.folder / name).write_text(text)
        return str(self.folder / name)

    def experiment(self, controller="together", rule="Count", replaced=("", "")):
        return self.write("experiment.xml", EXPERIMENT.format(controller=controller, rule=rule).replace(*replaced))

    def call(self, *arguments, code=0):
        """@return the completed process of a command of `swarmanoid`"""
        done = subprocess.run(["swarmanoid", *arguments], cwd=self.folder, capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, code, done.stderr)
        return done

    def rows_of_batch(self, experiment, code=0):
        self.call("batch", experiment, "--seeds", "1..3", "--no-report", "--out", "runs.csv", "--force", "--jobs", "1", "--quiet",
                  code=code)
        with open(self.folder / "runs.csv", newline="") as file:
            return sorted(csv.DictReader(file), key=lambda row: int(row["seed"]))

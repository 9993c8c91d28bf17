#!/usr/bin/python3
"""Controllers and rules in Python that an experiment file names: the same runs in Python and in the program, and what becomes of
mistakes."""

import csv
import json
import os
import pathlib
import shutil
import subprocess
import tempfile
import textwrap
import unittest

import swarmanoid

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


class ScriptsTest(unittest.TestCase):
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
        """@return what a command of `swarmanoid` says"""
        done = subprocess.run(["swarmanoid", *arguments], cwd=self.folder, capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, code, done.stderr)
        return done

    def refusal(self, **options):
        """@return why the experiment is refused, in Python as by the program"""
        experiment = self.experiment(**options)
        with self.assertRaises(swarmanoid.ExperimentError) as caught:
            swarmanoid.Simulation(experiment)
        said = self.call("run", experiment, code=2).stderr
        text = str(caught.exception)
        self.assertIn(text.splitlines()[0].replace(str(self.folder) + "/", ""), said.replace(str(self.folder) + "/", ""))
        return text

    def test_a_file_runs_as_its_parts_do_in_python_and_in_the_program(self):
        for controller in ("together", "One"):
            with self.subTest(controller):
                here = swarmanoid.Simulation(self.experiment(controller))
                said = self.call("run", self.experiment(controller), "--quiet")
                self.assertEqual(said.stderr, "")
                there = json.loads(said.stdout)
                result = here.run()
                self.assertEqual(result["state_hash"], there["state_hash"])
                self.assertEqual(result["metrics"], there["metrics"])
                self.assertEqual(result["metrics"]["count.calls"], 60)
                self.assertGreater(result["metrics"]["count.seen"], 60)
                namespace = {"__name__": "swarm"}
                sys_path_free = SWARM.replace("import beside\n", "").replace("beside.NEAR", "0.02")
                exec(compile(sys_path_free, "swarm.py", "exec"), namespace)
                given = swarmanoid.Simulation(self.experiment(controller), controllers={"dc": namespace[controller]})
                self.assertEqual(given.run()["state_hash"], result["state_hash"])

    def test_it_drives_as_it_says(self):
        simulation = swarmanoid.Simulation(self.experiment("together", replaced=("3.5", "4.25")))
        simulation.tick(3)
        right = simulation.robots.commands["footbot_wheels"].right
        self.assertTrue((right == 4.25).all(), right)

    def test_runs_share_no_module(self):
        experiment = self.experiment()
        first, second = swarmanoid.Simulation(experiment), swarmanoid.Simulation(experiment)
        first.tick(7)
        second.tick(4)
        self.assertEqual([run.metrics["count.calls"] for run in (first, second)], [7, 4])

    def test_a_reset_run_is_a_new_one(self):
        for controller, rule in (("One", "Count"), ("remembers", "Instances")):
            with self.subTest(controller):
                simulation = swarmanoid.Simulation(self.experiment(controller, rule))
                once = simulation.run()
                simulation.reset()
                self.assertEqual(simulation.run(), once)

    def test_a_record_has_the_files_and_makes_the_run_again(self):
        self.write("swarm.py", SWARM.replace("import beside\n", "").replace("beside.NEAR", "0.02"))  # what is imported is not kept
        self.call("run", self.experiment(), "--record", "record")
        kept = [file.name for file in (self.folder / "record/files").iterdir()]
        self.assertEqual(len(kept), 1, kept)
        self.write("swarm.py", "raise RuntimeError('the record has its own')")
        self.assertIn("each of 60 ticks has the state of the recorded run", self.call("rerun", "record").stdout)

    def rows_of_batch(self, experiment, code=0):
        self.call("batch", experiment, "--seeds", "1..3", "--no-report", "--out", "runs.csv", "--force", "--jobs", "1", "--quiet",
                  code=code)
        with open(self.folder / "runs.csv", newline="") as file:
            return sorted(csv.DictReader(file), key=lambda row: int(row["seed"]))

    def test_batches_make_the_runs_of_the_program(self):
        for controller, rule in (("together", "Count"), ("remembers", "Instances")):
            with self.subTest(controller):
                experiment = self.experiment(controller, rule)
                for row in self.rows_of_batch(experiment):
                    alone = json.loads(self.call("run", experiment, "--seed", row["seed"]).stdout)
                    self.assertEqual(row["state_hash"], alone["state_hash"])
                    for name, value in alone["metrics"].items():
                        self.assertEqual(float(row[name]), value)

    def test_a_batch_has_what_is_left_of_a_run_whose_controllers_fail(self):
        row = self.rows_of_batch(self.experiment("breaks"), code=3)[0]
        self.assertEqual(row["ticks"], "60")
        self.assertIn("ZeroDivisionError", row["failure"])

    def test_what_a_controller_throws_stops_its_robots(self):
        done = self.call("run", self.experiment("breaks"), code=3)
        result = json.loads(done.stdout)
        self.assertEqual(result["ticks"], 60)
        self.assertEqual(len(result["failed_controllers"]), 9)
        self.assertRegex(result["failed_controllers"][0]["reason"], r"^ZeroDivisionError: division by zero \(.*/swarm.py:\d+\)$")
        self.assertIn("said by Python", done.stderr)
        self.assertEqual(swarmanoid.Simulation(self.experiment("breaks")).run()["failed_controllers"], result["failed_controllers"])

    def test_an_exit_is_a_failure_as_well(self):
        result = json.loads(self.call("run", self.experiment("leaves"), code=3).stdout)
        self.assertIn("SystemExit: 7", result["failed_controllers"][0]["reason"])
        self.assertEqual(swarmanoid.Simulation(self.experiment("leaves")).run()["failed_controllers"], result["failed_controllers"])
        self.write("swarm.py", SWARM + "\n\nclass Exits:\n    def init(self, parameters):\n        raise SystemExit(5)\n")
        said = self.call("batch", self.experiment(rule="Exits"), "--seeds", "1..3", "--no-report", "--out", "runs.csv", code=2).stderr
        self.assertIn("rule 'count', init: SystemExit: 5", said)

    def test_what_a_rule_throws_stops_the_run(self):
        self.assertIn("rule 'count', after_tick: RuntimeError: no more",
                      self.call("run", self.experiment(rule="Broken"), code=4).stderr)
        with self.assertRaises(swarmanoid.RuleError):
            swarmanoid.Simulation(self.experiment(rule="Broken")).run()

    def test_what_is_beside_a_file_is_its_own(self):
        drive = "import queue\n\ndef together(robots):\n    robots.commands['footbot_wheels'].left = queue.SPEED\n" + SWARM.split("calls = 0")[1].replace(
            "together = All()", "")
        for folder, speed in (("a", 1), ("b", 4)):
            (self.folder / folder).mkdir()
            self.write(f"{folder}/swarm.py", "import beside\nimport numpy\ncalls = 0\n" + drive)
            self.write(f"{folder}/beside.py", "NEAR = 0.02\n")
            self.write(f"{folder}/queue.py", f"SPEED = {speed}\n")                  # a name of the library of Python
            (self.folder / folder / "experiment.xml").write_text(EXPERIMENT.format(controller="together", rule="Count"))
        import queue
        for folder, speed in (("a", 1), ("b", 4), ("a", 1)):
            simulation = swarmanoid.Simulation(str(self.folder / folder / "experiment.xml"))
            simulation.tick(2)
            self.assertTrue((simulation.robots.commands["footbot_wheels"].left == speed).all())
        import queue as same
        self.assertIs(queue, same)
        self.assertTrue(hasattr(queue, "Queue"))

    def test_a_file_that_changes_within_a_second_is_read_as_it_is(self):
        environment = {name: value for name, value in os.environ.items() if name != "PYTHONDONTWRITEBYTECODE"}
        for speed in range(1, 6):
            self.write("swarm.py", SWARM + f"\n\ndef fixed(robots):\n    robots.commands['footbot_wheels'].left = {speed}\n")
            self.write("beside.py", f"NEAR = 0.0{speed}\n")
            hashes = [json.loads(subprocess.run(["swarmanoid", "run", self.experiment("fixed"), "--quiet"], cwd=self.folder, check=True,
                                                env=environment, capture_output=True, text=True).stdout)["state_hash"],
                      swarmanoid.Simulation(self.experiment("fixed")).run()["state_hash"]]
            self.assertEqual(hashes[0], hashes[1])
            self.assertFalse((self.folder / "__pycache__").exists())

    def test_the_program_finds_python_by_itself(self):
        program = shutil.which("swarmanoid")
        (self.folder / "bin").mkdir()
        (self.folder / "bin/python3").symlink_to("/bin/false")
        for environment in ({}, {"PATH": str(self.folder / "bin")}, {"PYTHONPATH": str(self.folder)}):
            done = subprocess.run([program, "run", self.experiment(), "--quiet"], cwd=self.folder, env=environment,
                                  capture_output=True, text=True, check=False)
            self.assertEqual((done.returncode, done.stderr), (0, ""))

    def test_what_a_file_holds_is_given_back(self):
        self.write("swarm.py", SWARM + "\n\nlog = open('log.txt', 'w')\n\n\ndef writes(robots):\n    print(robots.tick, file=log)\n")
        self.call("run", self.experiment("writes"))
        self.assertEqual((self.folder / "log.txt").read_text().split(), [str(tick) for tick in range(60)])

    def test_data_classes_and_odd_errors(self):
        self.write("swarm.py", "from __future__ import annotations\n" + SWARM + textwrap.dedent("""

            import dataclasses
            import pickle


            @dataclasses.dataclass
            class State:
                level: float = 0.5


            class Odd(Exception):
                def __str__(self):
                    raise ValueError("no text")


            def odd(robots):
                assert pickle.loads(pickle.dumps(State())) == State()
                raise Odd() if robots.tick else ValueError("two\\nlines \\ud800")
            """))
        reasons = {failure["reason"].split(" (")[0] for failure in swarmanoid.Simulation(self.experiment("odd")).run()["failed_controllers"]}
        self.assertEqual(reasons, {"ValueError: two lines \\ud800"})

    def test_parameters_are_texts_and_dictionaries(self):
        self.write("swarm.py", SWARM + "\n\nclass Shows(Count):\n    def init(self, parameters):\n        print(parameters)\n        self.seen, self.limit = 0, 1.0\n")
        experiment = self.experiment(rule="Shows", replaced=("<limit>0.9</limit>", '<limit unit="m">0.9</limit><deep><a>1</a></deep>'))
        said = self.call("run", experiment, "--quiet").stderr
        self.assertEqual(said, "{'limit': {'unit': 'm', '': '0.9'}, 'deep': {'a': '1'}}\n")

    def test_mistakes_have_a_place(self):
        wrong = {
            "found the controller 'togeth', allowed: ": {"controller": "togeth"},
            "did you mean 'together'?": {"controller": "togeth"},
            "found the rule 'Cont'": {"rule": "Cont"},
            "experiment.xml:21: found the object 'count' a second time, allowed: once": {"rule": "Rules", "replaced": (
                '<Rules id="count" source="python" file="swarm.py"><limit>0.9</limit></Rules>',
                "\n".join(f'<count id="{name}" source="python" file="{file}swarm.py"><limit>1</limit></count>'
                          for name, file in (("a", ""), ("b", "./"))))},
            "found a controller 3, allowed: a function of the robots": {"controller": "number"},
            "found a rule 3, allowed: an object with functions of init": {"rule": "number"},
            "file: found 'swam.py', allowed: a file that is there and ends in .py": {"replaced": ("swarm.py", "swam.py")},
            "allowed: file, the name of a file in Python": {"replaced": ("file=", "library='x' file=")},
            "file: found 'swarm.py', allowed: with source=\"python\"": {"replaced": ("source=\"python\"", "")},
            "source: found the value 'lua', allowed: cpp, python": {"replaced": ("\"python\"", "\"lua\"")},
        }
        for text, options in wrong.items():
            with self.subTest(text):
                self.assertIn(text, self.refusal(**options))

    def test_a_controller_that_refuses_its_parameters(self):
        with self.assertRaisesRegex(swarmanoid.ExperimentError, "does not start: ValueError: found speed 3.5, allowed: 4 "):
            swarmanoid.Simulation(self.experiment("refuses"))
        self.assertIn("experiment.xml:5: controller 'dc' of all its robots does not start: ValueError: found speed 3.5, allowed: 4 (",
                      self.call("run", self.experiment("refuses"), code=2).stderr)

    def test_files_that_cannot_be_read_say_where(self):
        for code, text in (("a = 1\nb = (\n", "SyntaxError"), ("x = 1\ny = x / 0\n", "swarm.py:2)"), ("import nothing_of_that_name", "No module")):
            with self.subTest(code):
                self.write("swarm.py", textwrap.dedent(code))
                found = self.refusal()
                self.assertIn(text, found)
                self.assertIn("experiment.xml:5", found)

    def test_a_check_without_libraries_runs_no_code(self):
        self.write("swarm.py", "raise RuntimeError('run')")
        # diffusion and dispersion are names of the suite's, too
        for controller, rule in (("together", "Count"), ("diffusion", "dispersion")):
            self.assertIn("swarm.py", self.call("validate", "--no-libraries", self.experiment(controller, rule)).stdout)
        self.assertIn("run", self.call("validate", self.experiment(), code=2).stderr)


if __name__ == "__main__":
    unittest.main()

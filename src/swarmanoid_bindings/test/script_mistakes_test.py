#!/usr/bin/python3
"""Handling of errors in Python controllers and rules that an experiment file names."""

import json
import os
import site
import textwrap
import unittest

import swarmanoid
from swarmanoid import _scripts

from script_world import SWARM, ScriptCase


class ScriptMistakesTest(ScriptCase):
    def refusal(self, **options):
        """@return the reason for rejecting the experiment, which is the same in Python and in the program"""
        experiment = self.experiment(**options)
        with self.assertRaises(swarmanoid.ExperimentError) as caught:
            swarmanoid.Simulation(experiment)
        said = self.call("run", experiment, code=2).stderr
        text = str(caught.exception)
        self.assertIn(text.splitlines()[0].replace(str(self.folder) + "/", ""), said.replace(str(self.folder) + "/", ""))
        return text

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

    def test_what_a_library_throws_has_the_place_in_the_users_file(self):
        text = SWARM + textwrap.dedent("""

            class Mistakes:
                def init(self, robot, parameters):
                    self.number = int(robot.name.split("_")[1]) % 4

                def step(self, robot):
                    if self.number == 0:
                        robot.commands["footbot_wheels"].lefft = 1.0
                        robot.readings["footbot_proximity"].valu
                    if self.number == 1:
                        robot.commands["footbot_wheels"].left = "fast"
                    if self.number == 2:
                        robot.readings["proximity"]
                    numpy.concatenate([numpy.zeros(2), numpy.linalg.inv(numpy.zeros((2, 2)))])
            """)
        self.write("swarm.py", text)
        lines = text.splitlines()
        places = set()
        for failure in swarmanoid.Simulation(self.experiment("Mistakes")).run()["failed_controllers"]:
            self.assertRegex(failure["reason"], r" \(.*/swarm\.py:\d+\)$")
            places.add(lines[int(failure["reason"].rsplit(":", 1)[1][:-1]) - 1].strip())
        self.assertEqual(places, {'robot.commands["footbot_wheels"].lefft = 1.0', 'robot.commands["footbot_wheels"].left = "fast"',
                                  'robot.readings["proximity"]',
                                  "numpy.concatenate([numpy.zeros(2), numpy.linalg.inv(numpy.zeros((2, 2)))])"})

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
        failures = swarmanoid.Simulation(self.experiment("odd")).run()["failed_controllers"]
        reasons = {failure["reason"].split(" (")[0] for failure in failures}
        self.assertEqual(reasons, {"ValueError: two lines \\ud800"})

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

    def test_packages_that_a_user_has_installed_are_libraries(self):
        self.assertTrue(_scripts.is_in_library(os.path.join(site.getusersitepackages(), "package.py")))
        self.assertFalse(_scripts.is_in_library(str(self.folder / "swarm.py")))

    def test_files_that_cannot_be_read_say_where(self):
        for code, text in (("a = 1\nb = (\n", "SyntaxError"), ("x = 1\ny = x / 0\n", "swarm.py:2)"),
                           ("import nothing_of_that_name", "No module")):
            with self.subTest(code):
                self.write("swarm.py", textwrap.dedent(code))
                found = self.refusal()
                self.assertIn(text, found)
                self.assertIn("experiment.xml:5", found)

    def test_a_check_without_libraries_runs_no_code(self):
        self.write("swarm.py", "raise RuntimeError('run')")
        # diffusion and dispersion are also names of the suite
        for controller, rule in (("together", "Count"), ("diffusion", "dispersion")):
            self.assertIn("swarm.py", self.call("validate", "--no-libraries", self.experiment(controller, rule)).stdout)
        self.assertIn("run", self.call("validate", self.experiment(), code=2).stderr)


if __name__ == "__main__":
    unittest.main()

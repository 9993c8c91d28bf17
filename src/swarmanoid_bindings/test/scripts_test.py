#!/usr/bin/python3
"""Python controllers and rules that an experiment file names give the same runs in Python, in the program and in batches."""

import json
import os
import shutil
import subprocess
import unittest

import swarmanoid

from script_world import EXPERIMENT, SWARM, ScriptCase

PLACES = """    def step(self, robots):
        values = numpy.random.default_rng(1).uniform(0.05, 3, (150, 7))
        functions = [lambda p, name=name: getattr(numpy, name)(p[:, 5]) for name in ("sin", "cos", "tan", "arctan", "exp", "log", "sinh", "exp2")]
        functions.append(lambda p: numpy.arctan2(p[:, 5], p[:, 6]))
        kept = []
        for k in range(400):
            kept = kept[-50:] + [numpy.empty(1 + 37 * k % 400)]
            first = k % 8
            placed = numpy.empty(values.size + 8)[first:first + values.size].reshape(values.shape)
            placed[:] = values
            for function in functions:
                assert (function(placed) == function(values)).all()
"""


class ScriptsTest(ScriptCase):
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

    def test_numpy_gives_the_same_bits_wherever_arrays_lie_in_memory(self):
        """With AVX-512, NumPy uses other versions of these functions for some alignments, unless these features are disabled."""
        self.write("swarm.py", SWARM.replace("    def step(self, robots):\n", PLACES, 1))
        environment = {name: value for name, value in os.environ.items() if name != "NPY_DISABLE_CPU_FEATURES"}
        done = subprocess.run(["swarmanoid", "run", str(self.experiment("together")), "--quiet", "--ticks", "3"], env=environment,
                              cwd=self.folder, capture_output=True, text=True, check=False)
        self.assertEqual((done.returncode, done.stderr), (0, ""))

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
        self.write("swarm.py", SWARM.replace("import beside\n", "").replace("beside.NEAR", "0.02"))  # records lack imports
        self.call("run", self.experiment(), "--record", "record")
        kept = [file.name for file in (self.folder / "record/files").iterdir()]
        self.assertEqual(len(kept), 1, kept)
        self.write("swarm.py", "raise RuntimeError('the record has its own')")
        self.assertIn("each of 60 ticks has the state of the recorded run", self.call("rerun", "record").stdout)

    def test_batches_make_the_runs_of_the_program(self):
        for controller, rule in (("together", "Count"), ("remembers", "Instances")):
            with self.subTest(controller):
                experiment = self.experiment(controller, rule)
                for row in self.rows_of_batch(experiment):
                    alone = json.loads(self.call("run", experiment, "--seed", row["seed"]).stdout)
                    self.assertEqual(row["state_hash"], alone["state_hash"])
                    for name, value in alone["metrics"].items():
                        self.assertEqual(float(row[name]), value)

    def test_what_is_beside_a_file_is_its_own(self):
        drive = ("import queue\n\ndef together(robots):\n    robots.commands['footbot_wheels'].left = queue.SPEED\n"
                 + SWARM.split("calls = 0")[1].replace("together = All()", ""))
        for folder, speed in (("a", 1), ("b", 4)):
            (self.folder / folder).mkdir()
            self.write(f"{folder}/swarm.py", "import beside\nimport numpy\ncalls = 0\n" + drive)
            self.write(f"{folder}/beside.py", "NEAR = 0.02\n")
            self.write(f"{folder}/queue.py", f"SPEED = {speed}\n")                  # also the name of a standard module
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

    def test_parameters_are_texts_and_dictionaries(self):
        self.write("swarm.py", SWARM + "\n\nclass Shows(Count):\n    def init(self, parameters):\n        print(parameters)\n"
                   "        self.seen, self.limit = 0, 1.0\n")
        experiment = self.experiment(rule="Shows", replaced=("<limit>0.9</limit>", '<limit unit="m">0.9</limit><deep><a>1</a></deep>'))
        said = self.call("run", experiment, "--quiet").stderr
        self.assertEqual(said, "{'limit': {'unit': 'm', '': '0.9'}, 'deep': {'a': '1'}}\n")


if __name__ == "__main__":
    unittest.main()

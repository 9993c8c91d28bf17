#!/usr/bin/python3
"""run_test.py: messages of ./run before it installs or builds."""

import os
import shutil
import subprocess
import tempfile
import unittest

from surroundings import REPOSITORY


class RunTest(unittest.TestCase):
    def setUp(self):
        """A copy without a build, in an environment whose PATH has no programs that install or build."""
        self.folder = tempfile.TemporaryDirectory(prefix="run_test")
        self.addCleanup(self.folder.cleanup)
        self.copy = os.path.join(self.folder.name, "swarmanoid")
        for part in ("scripts", "src/swarmanoid_experiments/experiments"):
            shutil.copytree(os.path.join(REPOSITORY, part), os.path.join(self.copy, part))
        for part in ("run", "packages.txt"):
            shutil.copy(os.path.join(REPOSITORY, part), self.copy)
        tools = os.path.join(self.folder.name, "tools")
        os.mkdir(tools)
        for tool in ("bash", "dirname", "env", "find", "grep", "paste", "sed", "sort"):
            os.symlink(shutil.which(tool), os.path.join(tools, tool))
        self.environment = {"PATH": tools, "LC_ALL": "C"}

    def run_with(self, *arguments):
        return subprocess.run([os.path.join(self.copy, "run"), *arguments], env=self.environment, capture_output=True, text=True,
                              timeout=60)

    def test_help_comes_at_once(self):
        for option in ("-h", "--help"):
            done = self.run_with(option)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            self.assertTrue(done.stdout.startswith("./run [--headless] [EXPERIMENT] [OPTION...]: "), done.stdout)
            self.assertNotIn("set -euo", done.stdout)
            self.assertFalse(os.path.exists(os.path.join(self.copy, "build")))

    def test_a_mistyped_experiment_is_refused_at_once(self):
        for arguments in (("difusion",), ("--headless", "difusion", "--seed", "3")):
            done = self.run_with(*arguments)
            self.assertEqual(done.returncode, 2)
            self.assertIn("there is no file and no experiment 'difusion'; there are: aggregation, ", done.stderr)
            self.assertIn(", diffusion, ", done.stderr)
            self.assertEqual(done.stdout, "")

    def test_an_experiment_that_there_is_goes_on(self):
        done = self.run_with("--headless", "diffusion")
        self.assertNotEqual(done.returncode, 0, "nothing here can build")
        self.assertNotIn("there is no file", done.stderr)


if __name__ == "__main__":
    unittest.main()

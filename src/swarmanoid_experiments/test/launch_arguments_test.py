#!/usr/bin/env python3
"""The output of `roslaunch --ros-args` for the launch files: an argument is required exactly if it has no default."""

import pathlib
import subprocess
import unittest
import xml.etree.ElementTree

LAUNCH = pathlib.Path(__file__).resolve().parents[3] / "launch"


def required(file):
    """Returns the arguments that roslaunch lists as required."""
    listed = subprocess.run(["roslaunch", "--ros-args", file], check=True, timeout=60, stdout=subprocess.PIPE, encoding="utf-8").stdout
    part = listed.partition("Required Arguments:")[2].partition("Optional Arguments:")[0]
    return {line.split(":")[0].strip() for line in part.splitlines() if line.strip()}


class LaunchArgumentsTest(unittest.TestCase):
    def test_arguments_with_a_default_are_optional(self):
        files = sorted(LAUNCH.glob("*.launch"))
        self.assertEqual(len(files), 5)
        for file in files:
            with self.subTest(file.name):
                arguments = xml.etree.ElementTree.parse(file).getroot().findall("arg")
                self.assertEqual(required(file), {each.get("name") for each in arguments if each.get("default") is None})

    def test_a_robot_must_be_named(self):
        self.assertEqual(required(LAUNCH / "robot.launch"), {"robot", "controller"})


if __name__ == "__main__":
    unittest.main(argv=[pathlib.Path(__file__).name, "-v"])

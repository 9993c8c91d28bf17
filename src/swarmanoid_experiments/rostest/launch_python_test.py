#!/usr/bin/python3
"""An experiment with controllers and rules in Python, under ROS."""

import pathlib
import subprocess
import unittest

from roslaunch_process import LAUNCH_FOLDER, RoslaunchTest

DIFFUSION = LAUNCH_FOLDER.parent / "src/swarmanoid_experiments/experiments/diffusion.xml"
SWARM = """
import numpy


def turn(robots):
    wheels = robots.commands["footbot_wheels"]
    wheels.left = numpy.where(robots.readings["footbot_proximity"].value.any(axis=1), -3, robots.uniform(2, 5))
    wheels.right = 4


def breaks(robots):
    turn(robots)
    if robots.tick == 12:
        raise RuntimeError("no more")


class Count:
    def after_tick(self, world):
        self.moved = float(world.robots.poses[:, 0].sum())

    def metrics(self):
        return {"moved": getattr(self, "moved", 0.0)}
"""


class LaunchPythonTest(RoslaunchTest):
    launch_file = LAUNCH_FOLDER / "run.launch"

    def run_under_ros(self, controller):
        """Runs thirty ticks of diffusion with this controller. @return exit code and output of roslaunch"""
        text = DIFFUSION.read_text()
        self.assertEqual(text.count("</diffusion>"), 1)
        text = text.replace('<diffusion id="dc" library="diffusion">', f'<{controller} id="dc" source="python" file="swarm.py">')
        text = text.replace("</diffusion>", f"</{controller}>")
        text = text.replace("<rules>", '<rules><Count id="count" source="python" file="swarm.py"/>')
        pathlib.Path(self.folder.name, "mine.xml").write_text(text)
        pathlib.Path(self.folder.name, "swarm.py").write_text(SWARM)
        return self.output_of("rviz:=false", "experiment:=mine.xml", "max_ticks:=30", "real_time_factor:=0", "hashes:=ros.txt")

    def test_it_is_the_run_that_the_program_makes(self):
        code, output = self.run_under_ros("turn")
        self.assertEqual(code, 0, output)
        here = pathlib.Path(self.folder.name)
        subprocess.run(["swarmanoid", "run", "mine.xml", "--quiet", "--ticks", "30", "--hashes", "program.txt"], cwd=here, check=True)
        hashes = (here / "program.txt").read_text().splitlines()
        self.assertEqual(len({line.split()[1] for line in hashes}), 31, "nobody moves")
        self.assertEqual((here / "ros.txt").read_text().splitlines(), hashes)

    def test_what_it_throws_stops_its_robots(self):
        _, output = self.run_under_ros("breaks")
        self.assertIn("RuntimeError: no more", output)
        self.assertIn("exit code 3", output)


if __name__ == "__main__":
    unittest.main()

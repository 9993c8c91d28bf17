#!/usr/bin/env python3
"""`swarmanoid sample` writes tables of sensors that experiments can read."""

import pathlib
import unittest

from program_world import FINISHED, ProgramTest


class SampleTest(ProgramTest):
    def sample(self, *arguments):
        """@return lines of the table"""
        done = self.call("sample", *arguments, "--out", "table.csv", "--force")
        self.assertEqual((done.returncode, done.stdout, done.stderr), (FINISHED, "", ""))
        return (self.folder / "table.csv").read_text().splitlines()

    def test_a_table_has_a_line_for_each_distance_with_each_angle(self):
        lines = self.sample("footbot_proximity", "--distances", "0:0.02:0.1", "--angles", "0:35:80", "--set", "range=0.08")
        self.assertEqual(lines[0], "# footbot_proximity of a footbot, sensor 0, implementation polynomial; "
                                   "m, degrees, its own unit")
        self.assertEqual(lines[1], "distance,angle,reading")
        rows = [tuple(map(float, line.split(","))) for line in lines[2:]]
        self.assertEqual([row[:2] for row in rows],
                         [(distance, angle) for distance in (0, 0.02, 0.04, 0.06, 0.08, 0.1) for angle in (0, 35, 70)])
        for distance, angle, reading in rows:
            self.assertAlmostEqual(reading, max(0, 1 - distance / 0.08)**3, delta=1e-6, msg=f"{distance} m, {angle}")

    def test_without_a_grid_it_goes_as_far_as_the_sensor(self):
        lines = self.sample("light", "--robot", "footbot", "--sensor", 7)
        self.assertEqual(len(lines), 2 + 20 * 10)
        self.assertTrue(lines[-1].startswith("2,90,"), lines[-1])
        self.assertEqual(lines[2], "0.1,0,1")
        lines = self.sample("handbot_distance")
        self.assertEqual(len(lines), 2 + 21 * 9)
        self.assertEqual(lines[2], "0,0,-inf")

    def test_an_experiment_reads_the_table(self):
        self.sample("footbot_proximity")
        done = self.call("run", "diffusion", "--ticks", 20, "--quiet", "--record", "record",
                         "--set", "controllers.dc.sensors.footbot_proximity.implementation=sampled",
                         "--set", f"controllers.dc.sensors.footbot_proximity.file={self.folder / 'table.csv'}")
        self.assertEqual(done.returncode, FINISHED, done.stderr)
        (self.folder / "table.csv").unlink()
        self.assertEqual([file.name for file in (self.folder / "record/files").iterdir()], ["1_table.csv"])
        again = self.call("rerun", "record")
        self.assertEqual(again.returncode, FINISHED, again.stderr)

    def test_what_cannot_be_sampled_is_refused(self):
        def refused(message, *arguments):
            self.assert_refused(message, "sample", *arguments, "--out", "table.csv")

        refused("sample: found the sensor 'ligth', allowed: distances, eyebot_distance, footbot_base_ground, "
                "footbot_ground, footbot_proximity, ground, handbot_distance, light, proximity; did you mean 'light'?",
                "ligth", "--robot", "footbot")
        refused("--robot: found none, allowed: a robot with the sensor 'light'", "light")
        refused("--robot: found 'eyebot', which has no 'footbot_ground', allowed: footbot, and robots that carry it",
                "footbot_ground", "--robot", "eyebot")
        refused("--sensor: found 24, allowed: from 0 to 23", "footbot_proximity", "--sensor", 24)
        refused("--angles: found '0:10', allowed: FIRST:STEP:LAST", "footbot_proximity", "--angles", "0:10")
        refused("--angles: LAST: found '91', allowed: a number from 0 to 89", "footbot_proximity", "--angles", "0:10:91")
        refused("--angles: LAST: found '90', allowed: a number from 0 to 89", "handbot_distance", "--angles", "0:10:90")
        refused("--angles: LAST: found '91', allowed: a number from 0 to 90", "light", "--robot", "footbot",
                "--angles", "0:10:91")
        refused("--distances: found '0:0.1:1', which puts a lamp into the sensor, allowed: FIRST above 0",
                "light", "--robot", "footbot", "--distances", "0:0.1:1")
        refused("--distances: found '0:0.001:9', which are 9001 values, allowed: at most 1000",
                "footbot_proximity", "--distances", "0:0.001:9")
        refused("--set: range: found '7', allowed: a number from 0.001 to 1", "footbot_proximity", "--set", "range=7")
        refused("--set: found the parameter 'rnge', allowed: range, noise; did you mean 'range'?",
                "footbot_proximity", "--set", "rnge=1")
        refused("--set: found 'noise=0.07', by which readings have errors, allowed: parameters of the law, of which "
                "the table is", "footbot_proximity", "--set", "noise=0.07")
        (self.folder / "table.csv").write_text("mine")
        refused("--out: found 'table.csv', which is there already, allowed: another name, or --force to replace it", "footbot_proximity")
        self.assertEqual((self.folder / "table.csv").read_text(), "mine")


if __name__ == "__main__":
    unittest.main(argv=[pathlib.Path(__file__).name, "-v"])

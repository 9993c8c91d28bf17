#!/usr/bin/env python3
"""Devices of a robot from another package: those of any robot, and those that its description lists."""

import pathlib
import re
import shutil
import unittest

from program_world import BAD_INPUT, FINISHED, WORLD, ProgramTest

ROBOT = pathlib.Path(__file__).resolve().parents[3] / "examples/example_robot"


class RobotsTest(ProgramTest):
    def setUp(self):
        super().setUp()
        self.package = self.folder / "share/example_robot"
        shutil.copytree(ROBOT, self.package)
        self.put_before_prefixes()
        text = WORLD.replace("<footbot id", "<e_puck id").replace("</footbot>", "</e_puck>")
        self.file = self.world(text=text, visualisations="")

    def test_a_device_of_another_robot_must_be_listed(self):
        reason = "controller 'fc' uses the actuator 'footbot_wheels', which a e_puck does not have; it is for: footbot"
        self.assert_refused(f"{self.file}:10: {reason}", "validate", self.file)
        description = self.package / "urdf/e_puck.urdf"
        text = description.read_text()
        self.assertNotIn("footbot", text)
        description.write_text(text.replace('type="wheels"/>', 'type="wheels"/>\n    <device type="footbot_wheels"/>'))
        done = self.call("run", self.file, "--quiet")
        self.assertEqual(done.returncode, FINISHED, done.stderr)

    def test_a_device_of_any_robot_need_not_be_listed(self):
        description = self.package / "urdf/e_puck.urdf"
        text, count = re.subn(r" *<device .*\n", "", description.read_text())
        self.assertGreaterEqual(count, 4)
        description.write_text(text)
        done = self.call("validate", ROBOT / "e_pucks.xml")
        self.assertEqual((done.returncode, done.stderr), (FINISHED, ""))

    def test_its_ground_sensors_are_where_its_description_has_them(self):
        file = self.folder / "floor.xml"
        file.write_text((ROBOT / "e_pucks.xml").read_text().replace("<sensors>", "<sensors>\n        <ground/>"))
        done = self.call("validate", file)
        self.assertEqual((done.returncode, done.stderr), (FINISHED, ""))
        description = self.package / "urdf/e_puck.urdf"
        text = description.read_text()
        self.assertEqual(len(re.findall(r'<link name="ground_\d"/>', text)), 3)
        description.write_text(text.replace("ground_", "floor_"))
        done = self.call("validate", file)
        self.assertEqual(done.returncode, BAD_INPUT)
        self.assertIn("found the device 'ground' on a e_puck, allowed: on robots with links ground_0, ...", done.stderr)

    def test_who_moves_in_no_engine_is_a_warning(self):
        text = WORLD.replace('<entity id="fb"/>', "")
        line = 1 + text[:text.index("<footbot id")].count("\n")
        file = self.world(text=text, visualisations="")
        warning = (f"swarmanoid: warning: {file}:{line}: found the footbot 'fb' in no engine of <arena_physics>, so its "
                   "footbot_wheels will not move it\n")
        for command in (("validate",), ("run", "--quiet")):
            done = self.call(*command, file)
            self.assertEqual((done.returncode, done.stderr), (FINISHED, warning))
        file = self.world(text=text.replace("<controller>fc</controller>", ""), visualisations="")
        self.assertEqual(self.call("validate", file).stderr, "")


class CheckRobotTest(ProgramTest):
    """`check-robot` on an e-puck with a valid or a damaged description."""

    def setUp(self):
        super().setUp()
        self.file = self.folder / "e_puck.urdf"
        self.text = (ROBOT / "urdf/e_puck.urdf").read_text()

    def check(self, *changes):
        """@return the finished program, for the description with some texts replaced"""
        text = self.text
        for old, new in changes:
            self.assertIn(old, text)
            text = text.replace(old, new)
        self.file.write_text(text)
        return self.call("check-robot", self.file)

    def test_says_what_it_can_do(self):
        done = self.check()
        self.assertEqual((done.returncode, done.stderr), (FINISHED, ""))
        lines = done.stdout.splitlines()
        self.assertRegex(lines[0], r"^e_puck: 0\.\d+ kg, within 0\.035 m of its middle, up to 0\.053 m high$")
        self.assertEqual(lines[1], "wheels: radius 0.0205 m, 0.053 m apart, at most 6.28 rad/s (0.1287 m/s)")
        for line in ("engine: kinematics2d", "engine: dynamics2d", "engine: dynamics3d", "device: wheels",
                     "device: proximity", "device: ground",
                     "not: holders: found no holders, allowed: robots with holders"):
            self.assertIn(line, lines)
        self.assertFalse([line for line in lines if "footbot" in line], "devices of other robots are not its own")

    def test_what_a_sensor_lacks_is_said(self):
        lines = self.check(("ground_", "floor_")).stdout.splitlines()
        self.assertNotIn("device: ground", lines)
        self.assertTrue([line for line in lines if line.startswith(
            "not: ground: found the device 'ground' on a e_puck, allowed: on robots with links ground_0, ...")], lines)

    def test_all_mistakes_are_listed_at_once(self):
        done = self.check(('<cylinder radius="0.035" length="0.049"/>', '<mesh filename="body.stl"/>'),
                          ('<cylinder radius="0.006" length="0.041"/>', '<cylinder radius="0" length="0.041"/>'),
                          ('velocity="6.28"', 'velocity="0"'))
        self.assertEqual((done.returncode, done.stdout), (BAD_INPUT, ""))
        link = f"swarmanoid: {self.file}: link 'body': "
        bad_size = link + "found collision geometry with a size of 0 m, allowed: from 0.0001 to 10000"
        self.assertEqual(done.stderr.splitlines(), [
            link + "found a mesh as collision geometry, allowed are box, cylinder and sphere", bad_size, bad_size,
            f"swarmanoid: {self.file}: joint 'left_wheel_joint': found no limit of its velocity, expected one above 0 rad/s"])

    def test_unknown_devices_are_mistakes(self):
        done = self.check(('<device type="wheels"/>', '<device type="weels"/>'))
        self.assertEqual(done.returncode, BAD_INPUT)
        found = re.match(r"swarmanoid: \S+e_puck\.urdf: .*'weels', allowed: (.*); did you mean 'wheels'\?\n$", done.stderr)
        self.assertIsNotNone(found, done.stderr)
        allowed = found[1].split(", ")
        self.assertIn("proximity", allowed)
        self.assertEqual(len(allowed), len(set(allowed)), "each once")

    def test_what_is_no_robot_is_refused(self):
        self.text = "<robot"
        self.assertRegex(self.check().stderr, r"^swarmanoid: \S+e_puck\.urdf:1: .*\n$")
        self.assert_refused("nosuch.urdf: cannot be read", "check-robot", "nosuch.urdf")


if __name__ == "__main__":
    unittest.main(argv=[pathlib.Path(__file__).name, "-v"])

#!/usr/bin/env python3
"""Which devices a robot of somebody else's has: those of any robot, and those that its description lists."""

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


if __name__ == "__main__":
    unittest.main(argv=[pathlib.Path(__file__).name, "-v"])

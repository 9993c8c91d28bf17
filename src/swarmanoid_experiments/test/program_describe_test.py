#!/usr/bin/env python3
"""`swarmanoid describe` prints the descriptions of a device in headers, simulations and engines, as Markdown."""

import pathlib
import re
import unittest

from program_world import BAD_INPUT, FINISHED, ProgramTest


class DescribeTest(ProgramTest):
    def describe(self, *device):
        done = self.call("describe", *device)
        self.assertEqual((done.returncode, done.stderr), (FINISHED, ""))
        return done.stdout

    def test_one_is_a_part_of_all(self):
        everything = self.describe()
        names = re.findall(r"^# (\w+)$", everything, re.M)
        self.assertEqual(names, sorted(set(names)))
        listed = self.call("list", "sensor").stdout + self.call("list", "actuator").stdout
        self.assertEqual(names, sorted(set(re.findall(r"^  (\w+) \(", listed, re.M))))
        self.assertEqual("\n".join(self.describe(name) for name in (names[0], names[1], names[2])),
                         everything[:everything.index(f"\n# {names[3]}\n")])

    def test_fields_and_parameters_are_rows(self):
        text = self.describe("handbot_rope")
        self.assertTrue(text.startswith("# handbot_rope\n\nActuator. The rope with a magnet at its end"), text)
        for line in ("- Robot: `handbot`",
                     "- Struct: `HandbotRope` of `swarmanoid_interface/devices/handbot_rope.hpp`",
                     "| field | type | unit | range | at rest | meaning |",
                     "| `winding_speed` | `float64` | m/s | | 0 | positive shortens the rope; cut to max_speed either way |",
                     "## Implementation `default`",
                     "- Engines: `dynamics3d`",
                     "- Mechanisms: holder `rope`",
                     "| parameter | default | unit | range | meaning |",
                     "| `max_speed` | 0.2 | m/s | from 0 to 2 | The fastest winding, in and out. |"):
            self.assertIn(f"\n{line}\n", text)

    def test_ranges_and_resting_values(self):
        self.assertIn("\n| `left.shoulder` | `float64` | rad | from -1.57 to 0.7 | 0 | ", self.describe("handbot_arms"))
        self.assertIn("\n| `angle` | `float64` | rad | (-pi, pi] | 0 | ", self.describe("footbot_turret_state"))
        camera = self.describe("footbot_camera")
        self.assertIn("\n| `blobs[].distance` | `float32` | m | at least 0 | | ", camera)
        self.assertIn("\n| `blobs[].size` | `float32` | rad | at least 0 | | ", camera)
        self.assertIn("\n| `overflowed` | `bool` | | | false | ", camera)

    def test_the_channels_of_a_colour_share_a_row(self):
        ring = self.describe("footbot_leds")
        self.assertIn("\n| `ring[12].red`, `.green`, `.blue` | `uint8` | | from 0 to 255 | 0 | LED 0 is ahead", ring)
        self.assertIn("\nIt has no parameters.\n", ring)
        self.assertIn("\n- Robot: any\n", self.describe("leds"))

    def test_an_unknown_device_is_refused(self):
        done = self.call("describe", "footbot_weels")
        self.assertEqual(BAD_INPUT, done.returncode)
        self.assertRegex(done.stderr, r"^swarmanoid: describe: found the device 'footbot_weels', allowed: .*, footbot_wheels.*; "
                                      r"did you mean 'footbot_wheels'\?\n$")


if __name__ == "__main__":
    unittest.main(argv=[pathlib.Path(__file__).name, "-v"])

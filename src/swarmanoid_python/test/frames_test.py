#!/usr/bin/python3
"""Layouts and frames in Python against bytes written by hand."""

import struct
import types
import unittest

from swarmanoid_python.frames import Hosted
from swarmanoid_python.layout import Layout


class Truthful:
    """Converts to bool but is no boolean."""

    def __bool__(self):
        return True

    def __repr__(self):
        return "Truthful"


class LayoutTest(unittest.TestCase):
    def test_numbers_stand_one_after_the_other(self):
        data = b"\x01" + struct.pack("<d", -2.5) + struct.pack("<f", 0.5) + b"\x00"
        layout = Layout("u1 f8 f4 b1")
        self.assertEqual(([1, -2.5, 0.5, False], 14), layout.read(data))
        self.assertEqual(data, layout.write([1, -2.5, 0.5, False]))
        self.assertEqual([0, 0, 0, 0], layout.initial())

    def test_a_list_has_its_length_before_it(self):
        data = struct.pack("<I", 2) + b"\x07" + struct.pack("<f", 1.5) + b"\x08" + struct.pack("<f", -1.5) + b"\x01"
        layout = Layout("(u1 f4)* b1")
        self.assertEqual(([[(7, 1.5), (8, -1.5)], True], 15), layout.read(data))
        self.assertEqual(data, layout.write([[(7, 1.5), (8, -1.5)], True]))
        self.assertEqual([[], 0], layout.initial())

    def test_elements_of_a_list_have_arrays_number_by_number(self):
        data = struct.pack("<I", 2) + struct.pack("<f", 1.5) + b"\x07\xff" + struct.pack("<f", 0.25) + b"\x01\x02"
        layout = Layout("(f4 u1 u1)*")
        self.assertEqual(([[(1.5, 7, 255), (0.25, 1, 2)]], 16), layout.read(data))
        self.assertEqual(data, layout.write([[(1.5, 7, 255), (0.25, 1, 2)]]))

    def test_what_does_not_fit_is_refused(self):
        with self.assertRaisesRegex(ValueError, "found 'x3' in the layout 'f8 x3', allowed: f4, f8"):
            Layout("f8 x3")
        with self.assertRaisesRegex(ValueError, "found 3 values, allowed: 2"):
            Layout("f8 f8").write([1, 2, 3])
        with self.assertRaisesRegex(ValueError, "found 1 values, allowed: 2"):
            Layout("f8 f8").write([1])

    def test_a_value_that_does_not_fit_is_refused_with_its_name(self):
        names = ["leds/on", "leds/red", "leds/level"]
        layout = Layout("b1 u1 f4")
        self.assertEqual(b"\x01\xff" + struct.pack("<f", 0.5), layout.write([True, 255, 0.5], names))
        for values, text in (([True, 256, 0.5], "leds/red: found 256, allowed: a whole number from 0 to 255"),
                             ([True, 2.0, 0.5], "leds/red: found 2.0, allowed: a whole number from 0 to 255"),
                             ([True, 2, "high"], "leds/level: found 'high', allowed: a number of single precision"),
                             ([True, 2, 1e300], "leds/level: found 1e\\+300, allowed: a number of single precision")):
            with self.subTest(values=values), self.assertRaisesRegex(ValueError, f"^{text}$"):
                layout.write(values, names)
        with self.assertRaisesRegex(ValueError, "^found -129, allowed: a whole number from -128 to 127$"):
            Layout("i1").write([-129])

    def test_a_truth_value_is_a_bool_or_0_or_1(self):
        layout = Layout("f4 b1")
        for value, byte in ((True, b"\x01"), (False, b"\x00"), (1, b"\x01"), (0, b"\x00")):
            self.assertEqual(struct.pack("<f", 0.5) + byte, layout.write([0.5, value]))
        for value, shown in (("no", "'no'"), (None, "None"), (2, "2"), (-1, "-1"), (1.0, "1.0"), ([], "\\[\\]"),
                             (Truthful(), "Truthful")):
            text = f"^gripper/closed: found {shown}, allowed: True, False, 0 or 1$"
            with self.subTest(value=value), self.assertRaisesRegex(ValueError, text):
                layout.write([0.5, value], ["gripper/force", "gripper/closed"])
        with self.assertRaisesRegex(ValueError, "^found 'no', allowed: True, False, 0 or 1$"):
            Layout("(u1 b1)*").write([[(1, True), (2, "no")]])
        with self.assertRaisesRegex(ValueError, "^gripper/force: found 'no', allowed: a number of single precision$"):
            layout.write(["no", True], ["gripper/force", "gripper/closed"])

    def test_a_truth_value_may_be_that_of_numpy(self):
        try:
            import numpy  # pylint: disable=import-outside-toplevel
        except ImportError:
            self.skipTest("there is no numpy")
        values = [numpy.bool_(True), numpy.bool_(False), numpy.int64(1)]
        self.assertEqual(b"\x01\x00\x01", Layout("b1 b1 b1").write(values))
        for value in (numpy.int64(2), numpy.float64(1.0), numpy.array([True])):
            with self.subTest(value=value), self.assertRaisesRegex(ValueError, "allowed: True, False, 0 or 1$"):
                Layout("b1").write([value])


def device(kind, layout, names):
    return types.SimpleNamespace(type=kind, layout=layout, names=names)


class Follower:
    """Commands twice its reading; fails at 4."""

    made = 0

    def __init__(self, robot):
        Follower.made += 1
        self._robot = robot
        self._eye = robot.sensors.eye  # the same in each tick

    def step(self, time, dt):
        reading = self._eye.distance
        if reading == 4.0:
            raise RuntimeError("too much")
        self._robot.actuators.leg.speed = 2 * reading if reading != 5.0 else "fast"
        self._robot.debug("at", time)


class HostedTest(unittest.TestCase):
    def setUp(self):
        Follower.made = 0
        robot = types.SimpleNamespace(name="r", type="footbot", parameters=[], sensors=[device("eye", "f8", "distance")],
                                      actuators=[device("leg", "f8", "speed")])
        self.hosted = Hosted(robot, Follower)

    def answer(self, reading):
        return self.hosted.answer(b"\x01" + struct.pack("<Id", 8, reading), 0, 1, 1.5, 0.1)

    @staticmethod
    def stepped(command):
        debug = struct.pack("<I", 1) + struct.pack("<I", 2) + b"at" + struct.pack("<I", 3) + b"1.5"
        return b"\x01" + struct.pack("<Id", 8, command) + debug

    def test_a_reading_becomes_a_command(self):
        self.assertEqual((self.stepped(3.0), 13), self.answer(1.5))

    def test_each_tick_has_its_reading(self):
        self.answer(1.5)
        self.assertEqual(self.stepped(-1.0), self.answer(-0.5)[0])

    def test_a_command_that_is_no_number_is_reported_with_its_name(self):
        text = b"ValueError: leg/speed: found 'fast', allowed: a number"
        self.assertEqual(b"\x02" + struct.pack("<I", len(text)) + text, self.answer(5.0)[0])

    def test_who_is_absent_does_nothing_and_starts_anew(self):
        self.answer(1.0)
        self.assertEqual((b"\x00", 1), self.hosted.answer(b"\x00", 0, 1, 1.5, 0.1))
        self.answer(1.0)
        self.assertEqual(2, Follower.made)

    def test_a_failure_is_reported_and_lasts(self):
        text = b"RuntimeError: too much"
        failed = b"\x02" + struct.pack("<I", len(text)) + text
        self.assertEqual(failed, self.answer(4.0)[0])
        self.assertEqual(failed, self.answer(1.0)[0])

    def test_a_block_of_another_length_is_refused(self):
        with self.assertRaisesRegex(ValueError, "r, eye: found 9 bytes, expected 8"):
            self.hosted.answer(b"\x01" + struct.pack("<Idb", 9, 1.0, 0), 0, 1, 1.5, 0.1)


if __name__ == "__main__":
    unittest.main(verbosity=2)

#!/usr/bin/python3
"""Layouts and frames in Python against bytes that are written out here by hand."""

import struct
import types
import unittest

from swarmanoid_python.frames import Hosted
from swarmanoid_python.device import Device, Names
from swarmanoid_python.layout import Layout


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

    def test_what_does_not_fit_is_refused(self):
        with self.assertRaisesRegex(ValueError, "found 'x3' in the layout 'f8 x3', allowed: f4, f8"):
            Layout("f8 x3")
        with self.assertRaisesRegex(ValueError, "found 3 values, allowed: 2"):
            Layout("f8 f8").write([1, 2, 3])


class DeviceTest(unittest.TestCase):
    def test_fields_are_attributes_and_values_stay_a_list(self):
        wheels = Device([0.0, 0.0], Names("left right"))
        wheels.right = 2.5
        self.assertEqual([0.0, 2.5], wheels)
        wheels[0] = -1.0
        self.assertEqual(-1.0, wheels.left)
        wheels.take([7.0, 8.0])
        self.assertEqual(8.0, wheels["right"])

    def test_arrays_and_fields_of_fields(self):
        arms = Device(range(5), Names("left.elbow left.wrist value[0] value[1] value[2]"))
        self.assertEqual([0, 1], list(arms.left))
        self.assertEqual((1, 1), (arms.left.wrist, arms["left.wrist"]))
        self.assertEqual(3, len(arms.value))
        self.assertEqual((4, 4, 3), (arms.value[2], arms.value[-1], arms["value[1]"]))
        arms.value = [9, 8, 7]
        arms.left.elbow = 6
        self.assertEqual([6, 1, 9, 8, 7], arms)
        with self.assertRaisesRegex(ValueError, "found 2 values for 'value', allowed: 3"):
            arms.value = [1, 2]
        with self.assertRaises(IndexError):
            arms.value[3]  # pylint: disable=pointless-statement

    def test_elements_of_a_list_have_names_and_stay_tuples(self):
        camera = Device([[], 0], Names("blobs(color.red distance) overflowed"))
        camera.take([[(200, 1.5), (3, 0.25)], True])
        self.assertEqual((3, 0.25), camera.blobs[1])
        self.assertEqual((200, 1.5), (camera.blobs[0].color_red, camera.blobs[0].distance))
        self.assertTrue(camera.overflowed)

    def test_a_name_that_is_not_there_is_refused_with_those_that_are(self):
        wheels = Device([0.0, 0.0], Names("left right"))
        with self.assertRaisesRegex(AttributeError, "found no field 'lefft', allowed: left, right"):
            wheels.lefft = 1.0


def device(kind, layout, names):
    return types.SimpleNamespace(type=kind, layout=layout, names=names)


class Follower:
    """Commands what it reads, doubled; fails at 4."""

    made = 0

    def __init__(self, robot):
        Follower.made += 1
        self._robot = robot

    def step(self, time, dt):
        reading = self._robot.sensors["eye"].distance
        if reading == 4.0:
            raise RuntimeError("too much")
        self._robot.actuators["leg"].speed = 2 * reading
        self._robot.debug("at", time)


class HostedTest(unittest.TestCase):
    def setUp(self):
        Follower.made = 0
        self.hosted = Hosted(types.SimpleNamespace(name="r", type="footbot", parameters=[], sensors=[device("eye", "f8", "distance")],
                                                   actuators=[device("leg", "f8", "speed")]), Follower)

    def answer(self, reading):
        return self.hosted.answer(b"\x01" + struct.pack("<Id", 8, reading), 0, 1, 1.5, 0.1)

    @staticmethod
    def stepped(command):
        debug = struct.pack("<I", 1) + struct.pack("<I", 2) + b"at" + struct.pack("<I", 3) + b"1.5"
        return b"\x01" + struct.pack("<Id", 8, command) + debug

    def test_a_reading_becomes_a_command(self):
        self.assertEqual((self.stepped(3.0), 13), self.answer(1.5))

    def test_who_is_absent_does_nothing_and_starts_anew(self):
        self.answer(1.0)
        self.assertEqual((b"\x00", 1), self.hosted.answer(b"\x00", 0, 1, 1.5, 0.1))
        self.answer(1.0)
        self.assertEqual(2, Follower.made)

    def test_a_failure_is_told_and_lasts(self):
        text = b"RuntimeError: too much"
        failed = b"\x02" + struct.pack("<I", len(text)) + text
        self.assertEqual(failed, self.answer(4.0)[0])
        self.assertEqual(failed, self.answer(1.0)[0])

    def test_a_block_of_another_length_is_refused(self):
        with self.assertRaisesRegex(ValueError, "r, eye: found 9 bytes, expected 8"):
            self.hosted.answer(b"\x01" + struct.pack("<Idb", 9, 1.0, 0), 0, 1, 1.5, 0.1)


if __name__ == "__main__":
    unittest.main(verbosity=2)

#!/usr/bin/python3
"""Access to devices by the names of their fields, against values computed by hand."""

import copy
import unittest

from swarmanoid_python.device import Device, Devices, replace_values
from swarmanoid_python.names import Fields, UnknownName

ARMS = "left.elbow left.wrist right.elbow right.wrist"


def device(kind, names, values):
    return Device(list(values), Fields(kind, names))


class FieldsTest(unittest.TestCase):
    def test_fields_are_attributes_and_places_in_the_row_of_values(self):
        wheels = device("wheels", "left right", [0.0, 0.0])
        wheels.right = 2.5
        self.assertEqual([0.0, 2.5], wheels)
        wheels[0] = -1.0
        self.assertEqual(-1.0, wheels.left)
        wheels[:] = 7.0, 8.0
        self.assertEqual((7.0, 8.0), (wheels.left, wheels["right"]))
        left, right = wheels
        self.assertEqual((7.0, 8.0, 2), (left, right, len(wheels)))

    def test_arrays_and_fields_of_fields_are_views(self):
        arms = device("arms", ARMS + " value[0] value[1] value[2]", range(7))
        left, value = arms.left, arms.value
        replace_values(arms, range(10, 17))
        self.assertEqual((10, 11, 13), (left.elbow, left.wrist, arms["right.wrist"]))
        self.assertEqual([14, 15, 16], value)
        left.elbow = 1
        value[-1] = 2
        arms.right = 3, 4
        arms["value[0]"] = 5
        self.assertEqual([1, 11, 3, 4, 5, 15, 2], arms)

    def test_arrays_are_sequences(self):
        ring = device("ring", "value[0] value[1] value[2] value[3]", [0.5, 1.5, 2.5, 3.5]).value
        self.assertEqual((4, 3.5, 8.0), (len(ring), max(ring), sum(ring)))
        self.assertEqual(([1.5, 2.5], [3.5, 1.5]), (ring[1:3], ring[::-2]))
        ring[2:] = [8.0, 9.0]
        self.assertEqual([0.5, 1.5, 8.0, 9.0], list(ring))
        self.assertNotEqual(ring, None)
        for index in (4, -5):
            text = f"ring/value: found index {index}, allowed: -4 to 3"
            with self.subTest(index=index), self.assertRaisesRegex(IndexError, text):
                ring[index]  # pylint: disable=pointless-statement

    def test_arrays_of_structs(self):
        leds = device("leds", "ring[0].red ring[0].blue ring[1].red ring[1].blue", [0] * 4)
        leds.ring[1].blue = 9
        leds.ring[0] = 1, 2
        self.assertEqual([1, 2, 0, 9], leds)
        leds.ring = [(5, 6), (7, 8)]
        self.assertEqual([(5, 6), (7, 8)], [(led.red, led.blue) for led in leds.ring])

    def test_numpy_takes_an_array(self):
        try:
            import numpy  # pylint: disable=import-outside-toplevel
        except ImportError:
            self.skipTest("there is no numpy")
        velocity = device("flight", "linear[0] linear[1] linear[2] yaw_rate", [0.0] * 4)
        velocity.linear = numpy.array([1.0, 2.0, 3.0]) / 4
        self.assertEqual([0.25, 0.5, 0.75, 0.0], velocity)
        array = numpy.asarray(velocity.linear)
        self.assertEqual(("float64", (3,), 1.5), (str(array.dtype), array.shape, array.sum()))
        self.assertEqual(0.5, velocity.linear[numpy.int64(-2)])

    def test_a_field_may_have_the_name_of_a_method_of_lists(self):
        counter = device("counter", "count index values", [3, 4, 5])
        counter.index = 6
        self.assertEqual((3, 6, 5), (counter.count, counter.index, counter.values))

    def test_a_copy_keeps_its_values(self):
        for copied in (copy.copy, copy.deepcopy):
            wheels = device("wheels", "left right", [1.0, 2.0])
            before = copied(wheels)
            wheels.left = 9.0
            self.assertEqual((1.0, 9.0), (before.left, wheels.left))

    def test_devices_say_what_they_have(self):
        arms = device("arms", ARMS, [0.5, 1, 2, 3])
        self.assertEqual("arms(left=(elbow=0.5, wrist=1), right=(elbow=2, wrist=3))", repr(arms))
        self.assertEqual(["left", "right"], dir(arms))
        self.assertEqual("ring(value=[7, 8])", repr(device("ring", "value[0] value[1]", [7, 8])))


class ListsTest(unittest.TestCase):
    def setUp(self):
        self.camera = device("camera", "blobs(color.red color.blue distance) overflowed", [[], 0])
        replace_values(self.camera, [[(200, 1, 1.5), (3, 4, 0.25)], True])

    def test_elements_have_the_names_of_their_struct(self):
        near = self.camera.blobs[1]
        self.assertEqual((3, 4, 0.25), (near.color.red, near.color.blue, near.distance))
        self.assertEqual(1.5, self.camera["blobs[0].distance"])
        self.assertTrue(self.camera.overflowed)
        replace_values(self.camera, [[], False])
        self.assertEqual(([], False), (self.camera.blobs, self.camera.overflowed))

    def test_elements_have_names_as_text(self):
        self.assertIs(self.camera.blobs[1], self.camera["blobs[1]"])
        self.assertEqual(3, self.camera["blobs[1]"]["color.red"])
        self.assertEqual(4, self.camera["blobs[1].color"].blue)
        self.assertEqual([(200, 1, 1.5), (3, 4, 0.25)], self.camera["blobs"])

    def test_elements_are_assigned_by_text_as_they_are_by_index(self):
        lamps = device("lamps", "spots(red level)", [[(1, 0.5), (2, 1.5)]])
        lamps["spots[1]"] = 7, 2.5
        self.assertEqual([(1, 0.5), (7, 2.5)], lamps.spots)

    def test_elements_that_are_not_there_are_refused(self):
        found = "camera/blobs: found "
        camera, index, key = self.camera, IndexError, UnknownName
        for name, error, text in (("blobs[9]", index, found + "index 9, allowed: 0 to 1; elements in the list: 2"),
                                  ("blobs[2].distance", index,
                                   found + "index 2, allowed: 0 to 1; elements in the list: 2"),
                                  ("blobs.x", key, found + "no field 'x', allowed: [0] to [1]"),
                                  ("blobs.x.distance", key, found + "no field 'x', allowed: [0] to [1]"),
                                  ("blobs[0].size", key,
                                   "camera/blobs[]: found no field 'size', allowed: color, distance"),
                                  ("blobs[0][1]", key,
                                   "camera/blobs[]: found no field '1', allowed: color, distance"),
                                  ("overflowed[0]", key,
                                   "camera: found no field 'overflowed[0]', allowed: blobs, overflowed; "
                                   "did you mean 'overflowed'?")):
            for action, values in ((camera.__getitem__, ()), (camera.__setitem__, (1,))):
                with self.subTest(name=name), self.assertRaises(error) as raised:
                    action(name, *values)
                self.assertEqual(text, str(raised.exception))
        replace_values(camera, [[], False])
        with self.assertRaises(IndexError) as raised:
            camera["blobs[0]"]  # pylint: disable=pointless-statement
        self.assertEqual(found + "index 0, allowed: none; elements in the list: 0", str(raised.exception))

    def test_elements_are_rows_of_values(self):
        self.assertEqual([(200, 1, 1.5), (3, 4, 0.25)], self.camera.blobs)
        red, blue, distance = min(self.camera.blobs, key=lambda blob: blob.distance)
        self.assertEqual((3, 4, 0.25), (red, blue, distance))

    def test_elements_are_kept_and_not_written(self):
        first = self.camera.blobs[0]
        replace_values(self.camera, [[(0, 0, 9.0)], False])
        self.assertEqual(1.5, first.distance)
        with self.assertRaises(TypeError):
            first.distance = 2.0


class ArraysInListsTest(unittest.TestCase):
    def setUp(self):
        self.received = device("received", "messages(range payload[0] payload[1] payload[2]) overflowed", [[], 0])
        replace_values(self.received, [[(1.5, 7, 255, 0), (0.25, 1, 2, 3)], True])

    def test_elements_have_arrays(self):
        first, second = self.received.messages
        self.assertEqual((1.5, 255, 3), (first.range, first.payload[1], second["payload[2]"]))
        self.assertEqual(2, self.received["messages[1].payload[1]"])
        self.assertEqual(bytes([7, 255, 0]), bytes(first.payload))
        self.assertEqual("received/messages[](range=0.25, payload=[1, 2, 3])", repr(second))

    def test_an_array_of_an_element_is_kept_and_not_written(self):
        payload = self.received.messages[1].payload
        replace_values(self.received, [[], False])
        self.assertEqual([1, 2, 3], payload)
        with self.assertRaises(TypeError):
            payload[0] = 9
        with self.assertRaisesRegex(IndexError, r"received/messages\[\]/payload: found index 3, allowed: -3 to 2"):
            payload[3]  # pylint: disable=pointless-statement


class MistakesTest(unittest.TestCase):
    def refused(self, error, text, action):
        with self.assertRaises(error) as raised:
            action()
        self.assertEqual(text, str(raised.exception))

    def test_a_name_that_is_not_there_is_refused_with_those_that_are(self):
        wheels = device("wheels", "left right", [0.0, 0.0])
        self.refused(AttributeError, "wheels: found no field 'lefft', allowed: left, right; did you mean 'left'?",
                     lambda: setattr(wheels, "lefft", 1.0))
        self.refused(KeyError, "wheels: found no field 'speed', allowed: left, right", lambda: wheels["speed"])
        arms = device("arms", ARMS, range(4))
        self.refused(AttributeError, "arms/left: found no field 'knee', allowed: elbow, wrist", lambda: arms.left.knee)
        self.refused(UnknownName, "arms: found no field 'left.elbow.x', allowed: left, right",
                     lambda: arms["left.elbow.x"])
        self.refused(UnknownName, "arms: found no field '', allowed: left, right", lambda: arms[""])
        ring = device("ring", "value[0] value[1]", [0, 0])
        self.refused(AttributeError, "ring/value: found no field 'x', allowed: [0] to [1]", lambda: ring.value.x)
        self.assertFalse(hasattr(wheels, "speed"))

    def test_a_name_that_is_not_written_as_names_are_is_refused(self):
        arms = device("arms", ARMS + " value[0] value[1]", range(6))
        self.assertEqual(5, arms["value[1]"])
        for name in ("left..elbow", ".left.elbow", "left.elbow.", "[left].elbow", "left]elbow", "value[00]",
                     "value[01]", "value.[0]", "value[-1]", "value[]"):
            for action, values in ((arms.__getitem__, ()), (arms.__setitem__, (1,))):
                with self.subTest(name=name), self.assertRaises(UnknownName) as raised:
                    action(name, *values)
                text = f"arms: found no field '{name}', allowed: left, right, value"
                self.assertEqual(text, str(raised.exception).split(";")[0])
        self.refused(UnknownName, "arms: found no field '[left]', allowed: left, right, value; did you mean 'left'?",
                     lambda: arms["[left]"])
        self.refused(UnknownName, "arms/value: found no field '[00]', allowed: [0] to [1]", lambda: arms.value["[00]"])
        self.assertEqual([0, 1, 2, 3, 4, 5], arms)
        self.refused(ValueError,
                     "arms: found the name 'left..elbow', allowed: names such as 'left.elbow' and 'value[0]'",
                     lambda: Fields("arms", "left..elbow"))

    def test_one_value_is_not_several(self):
        arms = device("arms", ARMS + " value[0] value[1] value[2]", range(7))
        self.refused(ValueError, "arms/left: found 5, allowed: 2 values", lambda: setattr(arms, "left", 5))
        self.refused(ValueError, "arms/left: found None, allowed: 2 values", lambda: arms.__setitem__("left", None))
        self.refused(ValueError, "arms/value: found 0.5, allowed: 2 values",
                     lambda: arms.value.__setitem__(slice(1, 3), 0.5))
        self.refused(ValueError, "arms: found 5, allowed: 7 values", lambda: arms.__setitem__(slice(None), 5))
        leds = device("leds", "ring[0].red ring[0].blue ring[1].red ring[1].blue", [0] * 4)
        self.refused(ValueError, "leds/ring[0]: found 1, allowed: 2 values", lambda: setattr(leds, "ring", [1, 2]))
        self.assertEqual(([0, 1, 2, 3, 4, 5, 6], [0] * 4), (list(arms), list(leds)))

    def test_as_many_values_as_there_are_fields(self):
        arms = device("arms", ARMS, range(4))
        self.refused(ValueError, "arms/left: found 3 values, allowed: 2", lambda: setattr(arms, "left", [1, 2, 3]))
        self.refused(ValueError, "arms: found 1 values, allowed: 4", lambda: arms.__setitem__(slice(None), [1]))
        self.assertEqual([0, 1, 2, 3], arms)


class DevicesTest(unittest.TestCase):
    def setUp(self):
        self.actuators = Devices("actuator", {"wheels": device("wheels", "left right", [1.0, 2.0])})

    def test_devices_are_attributes_and_items(self):
        self.assertIs(self.actuators.wheels, self.actuators["wheels"])
        self.assertEqual(["wheels"], list(self.actuators))
        self.assertIn("wheels", self.actuators)
        self.assertNotIn("leds", self.actuators)
        self.assertEqual("actuators: wheels", repr(self.actuators))

    def test_values_are_assigned_to_the_device_that_is_there(self):
        wheels = self.actuators.wheels
        self.actuators["wheels"] = [3.0, 4.0]
        self.assertEqual(4.0, wheels.right)
        self.actuators.wheels = 5.0, 6.0
        self.assertEqual(6.0, wheels.right)
        with self.assertRaisesRegex(ValueError, "wheels: found 3 values, allowed: 2"):
            self.actuators.wheels = 1.0, 2.0, 3.0
        with self.assertRaisesRegex(ValueError, "^wheels: found 5, allowed: 2 values$"):
            self.actuators.wheels = 5
        with self.assertRaisesRegex(ValueError, "^wheels: found 5, allowed: 2 values$"):
            self.actuators["wheels"] = 5
        self.assertEqual([5.0, 6.0], wheels)

    def test_a_device_that_is_not_there_is_refused_with_those_that_are(self):
        text = "found no actuator 'wheel', allowed: wheels; did you mean 'wheels'\\?"
        for action in (lambda: self.actuators.wheel, lambda: self.actuators["wheel"],
                       lambda: setattr(self.actuators, "wheel", [1.0, 2.0])):
            with self.assertRaisesRegex(UnknownName, text):
                action()


if __name__ == "__main__":
    unittest.main(verbosity=2)

#!/usr/bin/python3
"""Fields of devices as arrays: shapes, types, lists, and write access."""

import unittest

import numpy
import swarmanoid


def step_once(action, experiment="object_retrieval", controller="fc"):
    """Calls the action in a step of a controller. @return the simulation afterwards"""
    simulation = swarmanoid.Simulation(experiment, seed=2, controllers={controller: action})
    simulation.tick()
    return simulation


class FieldsTest(unittest.TestCase):
    def test_arrays_have_the_types_and_shapes_of_the_fields(self):
        simulation = swarmanoid.Simulation("object_retrieval")
        simulation.tick(30)
        readings = simulation.robots.readings
        value = readings["footbot_proximity"].value
        self.assertEqual((value.shape, value.dtype), ((3, 24), numpy.float32))
        self.assertTrue(((value >= 0) & (value <= 1)).all())
        gripping = readings["footbot_gripper_state"].gripping
        self.assertEqual((gripping.shape, gripping.dtype), ((3,), numpy.bool_))
        linear = simulation.robots.commands["eyebot_velocity"].linear
        self.assertEqual((linear.shape, linear.dtype), ((1, 3), numpy.float64))
        self.assertEqual(dir(simulation.robots.commands["footbot_leds"].ring), ["blue", "green", "red"])

    def test_devices_are_of_those_robots_that_have_them(self):
        simulation = swarmanoid.Simulation("object_retrieval")
        robots = simulation.robots
        self.assertEqual(robots.types, ["footbot"] * 3 + ["eyebot"])
        self.assertEqual(list(robots.readings.owners("eyebot_camera")), [3])
        self.assertEqual(list(robots.readings.owners("footbot_camera")), [0, 1, 2])
        self.assertIn("footbot_camera", robots.readings)
        self.assertNotIn("footbot_wheels", robots.readings)  # an actuator
        with self.assertRaisesRegex(KeyError, "found the device 'footbot_camra', allowed: .*did you mean 'footbot_camera'"):
            robots.readings["footbot_camra"]
        with self.assertRaisesRegex(AttributeError, "found 'valve', allowed: value"):
            robots.readings["footbot_proximity"].valve

    def test_lists_are_the_elements_of_all_robots(self):
        simulation = swarmanoid.Simulation("object_retrieval")
        simulation.tick(100)
        blobs = simulation.robots.readings["footbot_camera"].blobs
        self.assertEqual(blobs.counts.shape, (3,))
        self.assertGreater(blobs.counts.sum(), 0)
        self.assertEqual(len(blobs), blobs.counts.sum())
        numpy.testing.assert_array_equal(blobs.robot, numpy.repeat([0, 1, 2], blobs.counts))
        self.assertEqual((blobs.distance.shape, blobs.distance.dtype), ((len(blobs),), numpy.float32))
        self.assertEqual(blobs.color.red.dtype, numpy.uint8)
        # the order within a robot is unspecified, but all blobs have a distance and a colour
        self.assertTrue((blobs.distance > 0).all())
        lit = blobs.color.red.astype(int) + blobs.color.green + blobs.color.blue
        self.assertTrue((lit > 0).all())

    def test_what_is_written_is_read_again(self):
        written = numpy.arange(36, dtype=numpy.uint8).reshape(3, 12)

        def light(robots):
            ring = robots.commands["footbot_leds"].ring
            ring.red = written
            ring.green = 200
            numpy.testing.assert_array_equal(ring.red, written)

        ring = step_once(light).robots.commands["footbot_leds"].ring
        numpy.testing.assert_array_equal(ring.red, written)
        numpy.testing.assert_array_equal(ring.green, numpy.full((3, 12), 200))
        numpy.testing.assert_array_equal(ring.blue, 0)

    def test_one_number_and_one_a_robot_become_the_shape_of_the_field(self):
        def drive(robots):
            robots.commands["footbot_wheels"].left = [1, 2, 3]
            robots.commands["footbot_wheels"].right = numpy.float32(0.5)

        wheels = step_once(drive).robots.commands["footbot_wheels"]
        numpy.testing.assert_array_equal(wheels.left, [1.0, 2.0, 3.0])
        numpy.testing.assert_array_equal(wheels.right, [0.5] * 3)

    def test_commands_may_be_written_in_place(self):
        kept = []

        def drive(robots):
            wheels = robots.commands["footbot_wheels"]
            wheels.left[numpy.array([False, True, True])] = 3.0
            wheels.left += 1.0
            wheels.right = 5.0
            wheels.right[0] -= 2.0
            robots.commands["footbot_leds"].ring.red[1, ::2] = 7
            kept.append(wheels.right)

        commands = step_once(drive).robots.commands
        numpy.testing.assert_array_equal(commands["footbot_wheels"].left, [1.0, 4.0, 4.0])
        numpy.testing.assert_array_equal(commands["footbot_wheels"].right, [3.0, 5.0, 5.0])
        numpy.testing.assert_array_equal(commands["footbot_leds"].ring.red[1], [7, 0] * 6)
        numpy.testing.assert_array_equal(commands["footbot_leds"].ring.red[[0, 2]], 0)
        with self.assertRaisesRegex(ValueError, "read-only"):
            kept[0][1] = 9.0  # the step is over
        with self.assertRaisesRegex(ValueError, "read-only"):
            commands["footbot_wheels"].left[0] = 9.0

    def test_arrays_that_are_no_commands_are_read_only(self):
        simulation = swarmanoid.Simulation("object_retrieval")
        simulation.tick(60)
        robots = simulation.robots
        blobs = robots.readings["footbot_camera"].blobs
        self.assertGreater(len(blobs), 0)
        wheels = robots.commands["footbot_wheels"]
        for array in (robots.poses, robots.twists, robots.numbers, robots.property("intensity"),
                      robots.readings["footbot_proximity"].value, robots.readings.owners("footbot_camera"), wheels.left,
                      blobs.distance, blobs.color.red, blobs.robot, blobs.counts, simulation.entities.poses):
            with self.assertRaisesRegex(ValueError, "read-only"):
                array[0] = 1
            with self.assertRaisesRegex(ValueError, "read-only"):
                array += 1

    def test_in_a_step_readings_are_read_only_and_drawn_numbers_belong_to_the_caller(self):
        kept = []

        def act(robots):
            kept.append(robots.readings["footbot_proximity"].value)
            numbers = robots.uniform()
            numbers *= 0.0
            self.assertFalse(numbers.any())
            kept[-1][0] = 1.0

        with self.assertRaisesRegex(ValueError, "read-only"):
            step_once(act)

    def test_arrays_of_an_earlier_tick_keep_their_values(self):
        kept = []

        def drive(robots):
            wheels = robots.commands["footbot_wheels"]
            wheels.left[:] = robots.tick + 0.25
            kept.append((robots.tick, robots.poses, robots.readings["footbot_camera"].blobs.distance, wheels.left))
            copies.append([each.copy() for each in kept[-1][1:]])

        copies = []
        simulation = swarmanoid.Simulation("object_retrieval", seed=2, controllers={"fc": drive})
        simulation.tick(25)
        for (tick, *arrays), expected in zip(kept, copies):
            for array, before in zip(arrays, expected):
                numpy.testing.assert_array_equal(array, before)
            self.assertEqual([tick + 0.25] * 3, arrays[2].tolist())
            with self.assertRaisesRegex(ValueError, "read-only"):
                arrays[2][0] = 9.0
        self.assertFalse((kept[0][1] == kept[24][1]).all(), "the robots have moved")

    def test_what_is_written_last_holds(self):
        def drive(robots):
            wheels = robots.commands["footbot_wheels"]
            left = wheels.left
            left[:] = 4.0
            wheels.left = [1.0, 2.0, 3.0]
            numpy.testing.assert_array_equal(left, [1.0, 2.0, 3.0])
            left[1] = 7.0

        wheels = step_once(drive).robots.commands["footbot_wheels"]
        numpy.testing.assert_array_equal(wheels.left, [1.0, 7.0, 3.0])

    def test_an_array_of_another_shape_is_not_written_back(self):
        def drive(robots):
            left = robots.commands["footbot_wheels"].left
            left[:] = 4.0
            left.resize(1, refcheck=False)

        numpy.testing.assert_array_equal(step_once(drive).robots.commands["footbot_wheels"].left, [0.0] * 3)

    def refused(self, error, message, action):
        with self.assertRaisesRegex(error, message):
            step_once(action)

    def test_what_does_not_fit_is_refused(self):
        def write(device, field, value):
            def action(robots):
                target = robots.commands[device]
                setattr(target, field, value)
            return action

        self.refused(ValueError, r"footbot_wheels.left: found the shape \(2,\), allowed: \(3,\)",
                     write("footbot_wheels", "left", [1.0, 2.0]))
        self.refused(TypeError, "footbot_wheels.left: found <U4, allowed: numbers", write("footbot_wheels", "left", "fast"))
        self.refused(AttributeError, "did you mean 'left'", write("footbot_wheels", "lef", 1.0))

        def too_bright(robots):
            robots.commands["footbot_leds"].ring.red = 256

        self.refused(ValueError, "footbot_leds.ring.red: found numbers that are no uint8", too_bright)

        def write_readings(robots):
            robots.readings["footbot_proximity"].value = 0.0

        self.refused(TypeError, "footbot_proximity.value is not written here", write_readings)

    def test_commands_are_not_written_between_ticks(self):
        simulation = swarmanoid.Simulation("diffusion")
        with self.assertRaisesRegex(TypeError, "is not written here"):
            simulation.robots.commands["footbot_wheels"].left = 1.0


if __name__ == "__main__":
    unittest.main()

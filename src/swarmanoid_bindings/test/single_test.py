#!/usr/bin/python3
"""Controllers with one object per robot: compared with C++ and with controllers of all robots, and their errors."""

import concurrent.futures
import math
import unittest

import numpy
import swarmanoid
from swarmanoid import Delete, SetCommandSource, Spawn

ANGLES = [(i if i <= 12 else i - 24) * (2 * math.pi / 24) for i in range(24)]
AHEAD = [(i, math.cos(angle), math.sin(angle)) for i, angle in enumerate(ANGLES) if abs(angle) <= 1.5]


class Diffusion:
    """Same as the C++ controller `diffusion`."""

    def init(self, robot, parameters):
        self.speed = float(parameters["speed"])
        self.proximity = robot.readings["footbot_proximity"]
        self.wheels = robot.commands["footbot_wheels"]
        self.turn_rate = 0.0

    def step(self, robot):
        x = y = 0.0
        value = self.proximity.value
        if value.any():
            for i, cosine, sine in AHEAD:
                x += float(value[i]) * cosine
                y += float(value[i]) * sine
        if math.hypot(x, y) <= 0.05:
            self.turn_rate = 0.0
            speed = self.speed
        else:
            self.turn_rate = self.turn_rate or (-1.5 if y > 0 else 1.5)
            speed = 0.0
        difference = 0.5 * self.turn_rate * 0.140
        self.wheels.left = (speed - difference) / 0.029
        self.wheels.right = (speed + difference) / 0.029


def simulate(controller, **options):
    return swarmanoid.Simulation("diffusion", controllers={"dc": controller}, **options)


def state_hash(controller, seed, ticks=150, **options):
    simulation = simulate(controller, seed=seed, **options)
    simulation.tick(ticks)
    return simulation.state_hash


class SingleTest(unittest.TestCase):
    def test_makes_the_bits_of_cpp(self):
        for seed in (3, 4):
            cpp = swarmanoid.Simulation("diffusion", seed=seed)
            cpp.tick(150)
            self.assertEqual(state_hash(Diffusion, seed), cpp.state_hash)
            self.assertEqual(state_hash(Diffusion, seed, threads=3), cpp.state_hash)

    def test_threads_of_one_process_make_the_same_runs(self):
        seeds = list(range(1, 6))
        alone = [state_hash(Diffusion, seed, 40) for seed in seeds]
        with concurrent.futures.ThreadPoolExecutor(4) as pool:
            self.assertEqual(list(pool.map(lambda seed: state_hash(Diffusion, seed, 40), seeds)), alone)

    def test_draws_the_numbers_of_the_robot(self):
        alone, together = [], []

        class Dice:
            def step(self, robot):
                alone.append((robot.uniform(), robot.gaussian(2, 0.5), robot.uniform(3, 4)))

        def dice(robots):
            together.extend(zip(robots.uniform(), robots.gaussian(2, 0.5), robots.uniform(3, 4)))

        simulate(Dice).tick(2)
        simulate(dice).tick(2)
        self.assertEqual(alone, together)

    def test_knows_itself_and_the_time(self):
        seen = []

        class Clock:
            def init(self, robot, parameters):
                self.parameters = parameters
                self.at_start = robot.tick

            def step(self, robot):
                seen.append((robot.name, robot.type, robot.tick, robot.time, robot.dt, self.parameters, repr(robot)))

        simulate(Clock).tick(2)
        self.assertEqual(seen[101], ("fb_2", "footbot", 1, 0.1, 0.1, {"speed": "0.1"}, "<footbot 'fb_2'>"))

    def test_reads_and_writes_all_kinds_of_fields(self):
        seen = []

        class Watcher:
            def init(self, robot, parameters):
                robot.commands["footbot_leds"].ring.red = 255

            def step(self, robot):
                leds = robot.commands["footbot_leds"]
                leds.ring.green = [7] * 12
                camera = robot.readings["footbot_camera"]
                gripping = robot.readings["footbot_gripper_state"].gripping
                seen.append((robot.name, leds.ring.red.tolist(), leds.ring.green.tolist(), gripping, camera.blobs.distance))

        simulation = swarmanoid.Simulation("object_retrieval", controllers={"fc": Watcher})
        simulation.tick(60)
        self.assertEqual(seen[0][1:4], ([255] * 12, [7] * 12, False))
        numpy.testing.assert_array_equal(simulation.robots.commands["footbot_leds"].ring.red, 255)
        blobs = simulation.robots.readings["footbot_camera"].blobs
        self.assertGreater(len(blobs), 0)
        for i, (_, _, _, _, distance) in enumerate(seen[-3:]):
            numpy.testing.assert_array_equal(distance, blobs.distance[blobs.robot == i])

    def test_arrays_belong_to_their_step(self):
        class Painter:
            def init(self, robot, parameters):
                self.ring = robot.commands["footbot_leds"].ring
                self.kept = []
                robots[robot.name] = self

            def step(self, robot):
                red = self.ring.red
                red[robot.tick % 12] = 10 * robot.tick + 7
                red[3:5] += 1
                self.ring.green = numpy.arange(12) + robot.tick
                self.ring.green[0] = 99
                assert self.ring.red is red
                near = robot.readings["footbot_proximity"].value
                self.kept.append((red, red.copy(), near, near.copy()))

        robots = {}
        simulation = swarmanoid.Simulation("object_retrieval", seed=3, controllers={"fc": Painter})
        simulation.tick(5)
        ring = simulation.robots.commands["footbot_leds"].ring
        self.assertEqual([7, 17, 27, 39, 48] + [0] * 7, ring.red[1].tolist())
        self.assertEqual([99] + list(range(5, 16)), ring.green[2].tolist())
        for controller in robots.values():
            self.assertEqual(5, len({each[0].tobytes() for each in controller.kept}), "each step has its array")
            for red, red_then, near, near_then in controller.kept:
                numpy.testing.assert_array_equal(red, red_then)
                numpy.testing.assert_array_equal(near, near_then)
                for array in (red, near, controller.ring.red):
                    with self.assertRaisesRegex(ValueError, "read-only"):
                        array[0] = 1
            with self.assertRaisesRegex(RuntimeError, "between two steps"):
                controller.ring.red = 5

    def test_robots_come_and_go_and_begin_anew(self):
        made = []

        class Counter:
            def init(self, robot, parameters):
                made.append(robot.name)
                self.steps = 0
                self.wheels = robot.commands["footbot_wheels"]

            def step(self, robot):
                self.steps += 1
                self.wheels.left = self.steps
                seen.append((robot.name, self.steps))

        seen = []
        simulation = swarmanoid.Simulation("phototaxis", controllers={"pc": Counter})
        simulation.tick()
        simulation.apply(Delete("fb_2"))
        simulation.apply(Spawn("footbot", "fb_5", (1, 1, 0), engines=["ground"], controller="pc"))
        simulation.apply(SetCommandSource("fb_3", "none"))
        seen.clear()
        simulation.tick()
        self.assertEqual(seen, [("fb_1", 2), ("fb_4", 2), ("fb_5", 1)])
        self.assertEqual(list(simulation.robots.commands["footbot_wheels"].left), [2, 0, 2, 1])
        simulation.apply(SetCommandSource("fb_3", "controller"))
        seen.clear()
        simulation.tick()
        self.assertEqual(seen, [("fb_1", 3), ("fb_3", 1), ("fb_4", 3), ("fb_5", 2)])
        self.assertEqual(made, ["fb_1", "fb_2", "fb_3", "fb_4", "fb_5", "fb_3"])
        simulation.reset()
        self.assertEqual(made[6:], ["fb_1", "fb_2", "fb_3", "fb_4"])

    def test_what_it_throws_stops_its_robot_alone(self):
        class Fragile:
            def init(self, robot, parameters):
                self.wheels = robot.commands["footbot_wheels"]

            def step(self, robot):
                self.wheels.left = self.wheels.right = 2.0
                if robot.name == "fb_7" and robot.tick == 3:
                    raise ValueError("no way out")

        simulation = simulate(Fragile)
        with self.assertRaisesRegex(ValueError, "no way out"):
            simulation.tick(10)
        self.assertEqual(simulation.ticks, 4)
        self.assertEqual([(failure["robot"], failure["tick"]) for failure in simulation.failures], [("fb_7", 3)])
        self.assertEqual(simulation.tick(2), 2)
        left = simulation.robots.commands["footbot_wheels"].left
        self.assertEqual((left[6], left[5]), (0.0, 2.0))

    def test_what_its_init_throws_refuses_the_experiment_or_the_intervention(self):
        class Picky:
            def init(self, robot, parameters):
                if robot.name.endswith("5"):
                    raise LookupError("an odd name")

            def step(self, robot):
                pass

        with self.assertRaisesRegex(swarmanoid.ExperimentError, "controller 'dc' of 'fb_5' does not start: LookupError: an odd name"):
            simulate(Picky)
        simulation = swarmanoid.Simulation("phototaxis", controllers={"pc": Picky})
        with self.assertRaisesRegex(swarmanoid.InterventionError, "controller 'pc' of 'fb_5' does not start"):
            simulation.apply(Spawn("footbot", "fb_5", (1, 1, 0), engines=["ground"], controller="pc"))
        self.assertEqual(simulation.tick(3), 3)

    def test_robots_act_in_their_steps_only(self):
        kept = []

        class Keeper:
            def step(self, robot):
                kept.append(robot)

        simulation = simulate(Keeper)
        simulation.tick()
        for act in (lambda: kept[0].uniform(), lambda: kept[0].time, lambda: kept[0].log("a")):
            with self.assertRaisesRegex(RuntimeError, "between two steps"):
                act()
        del simulation
        kept[0].commands["footbot_wheels"].left = 3.0   # memory of Python's own
        self.assertEqual(kept[0].commands["footbot_wheels"].left, 3.0)

    def test_what_does_not_fit_is_refused(self):
        def refused(error, message, action):
            class Wrong:
                def step(self, robot):
                    action(robot)

            with self.assertRaisesRegex(error, message):
                simulate(Wrong).tick()

        refused(KeyError, "found the device 'footbot_wheel', allowed: footbot_wheels; did you mean 'footbot_wheels'",
                lambda robot: robot.commands["footbot_wheel"])
        refused(AttributeError, "no attribute 'lef'", lambda robot: setattr(robot.commands["footbot_wheels"], "lef", 1))
        refused(AttributeError, "'lef', allowed: left, right; did you mean 'left'", lambda robot: robot.commands["footbot_wheels"].lef)
        refused(TypeError, "footbot_wheels.left: found 'fast', allowed: a number",
                lambda robot: setattr(robot.commands["footbot_wheels"], "left", "fast"))
        refused(AttributeError, "has no setter", lambda robot: setattr(robot.readings["footbot_proximity"], "value", 1))
        refused(ValueError, "read-only", lambda robot: robot.readings["footbot_proximity"].value.fill(0))
        with self.assertRaisesRegex(TypeError, "allowed: a class with a function step"):
            simulate(int)


if __name__ == "__main__":
    unittest.main()

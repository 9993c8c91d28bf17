#!/usr/bin/python3
"""Python controllers: their readings and commands, and handling of their errors."""

import signal
import threading
import unittest

import numpy
import swarmanoid


def wander(robots):
    """Drives each robot by its own random numbers."""
    wheels = robots.commands["footbot_wheels"]
    wheels.left = robots.uniform(-3.0, 5.0)
    wheels.right = robots.gaussian(2.0, 1.5)


def simulate(controller, **options):
    return swarmanoid.Simulation("diffusion", controllers={"dc": controller}, **options)


class ControllerTest(unittest.TestCase):
    def test_its_commands_drive_the_robots(self):
        def turn_on_the_spot(robots):
            wheels = robots.commands["footbot_wheels"]
            wheels.left = -1.5
            wheels.right = 1.5

        simulation = simulate(turn_on_the_spot, seed=2)
        before = simulation.robots.poses
        simulation.tick(7)
        after = simulation.robots.poses
        # only robots without contact: grippers extend beyond the bodies, and push
        apart = numpy.linalg.norm(before[:, None, :2] - before[None, :, :2], axis=2) + numpy.eye(len(before))
        alone = apart.min(axis=1) > 0.3
        self.assertGreater(alone.sum(), 80)
        numpy.testing.assert_allclose(after[alone, :3], before[alone, :3], atol=1e-12)
        # 0.7 s of 2 x 1.5 rad/s x 0.029 m / 0.14 m
        half = 0.5 * 0.7 * 3.0 * 0.029 / 0.14
        turn = numpy.abs((after[:, 3:] * before[:, 3:]).sum(axis=1))
        numpy.testing.assert_allclose(turn[alone], numpy.cos(half), atol=1e-12)

    def test_a_run_depends_on_its_seed_alone(self):
        def state_hash(seed, threads):
            simulation = simulate(wander, seed=seed, threads=threads)
            simulation.tick(40)
            return simulation.state_hash

        self.assertEqual(state_hash(3, 1), state_hash(3, 4))
        self.assertNotEqual(state_hash(3, 1), state_hash(4, 1))

    def test_robots_have_random_numbers_of_their_own(self):
        seen = []
        simulation = simulate(lambda robots: seen.append((robots.uniform(), robots.uniform())))
        simulation.tick(2)
        numbers = numpy.concatenate([draw for tick in seen for draw in tick])
        self.assertEqual(len(numpy.unique(numbers)), 400)
        self.assertTrue(((numbers >= 0) & (numbers < 1)).all())
        simulation.reset()
        simulation.tick(1)
        numpy.testing.assert_array_equal(seen[2][0], seen[0][0])

    def test_gets_its_parameters_and_the_time(self):
        class Controller:
            def init(self, parameters):
                self.parameters = parameters
                self.times = []

            def step(self, robots):
                self.times.append((robots.tick, robots.time, robots.dt, len(robots)))

        controller = Controller()
        simulation = simulate(controller, overrides={"controllers.dc.parameters.speed": 0.17})
        simulation.tick(3)
        self.assertEqual(controller.parameters, {"speed": "0.17"})
        self.assertEqual([time[0] for time in controller.times], [0, 1, 2])
        numpy.testing.assert_allclose([time[1:] for time in controller.times], [[0.1 * i, 0.1, 100] for i in range(3)])
        simulation.reset()
        self.assertEqual(controller.times, [])

    def test_what_it_throws_is_thrown_when_the_tick_is_over_and_stops_its_robots(self):
        def fail(robots):
            robots.commands["footbot_wheels"].left = 3.0
            robots.commands["footbot_wheels"].right = 3.0
            if robots.tick == 4:
                raise ValueError("no way out")

        simulation = simulate(fail)
        with self.assertRaisesRegex(ValueError, "no way out"):
            simulation.tick(10)
        self.assertEqual(simulation.ticks, 5)
        self.assertEqual(len(simulation.failures), 100)
        self.assertEqual(simulation.failures[0]["tick"], 4)
        self.assertIn("ValueError: no way out", simulation.failures[0]["reason"])
        self.assertEqual(simulation.tick(2), 2)  # the world goes on
        numpy.testing.assert_array_equal(simulation.robots.twists, 0.0)

    def test_a_number_that_is_not_finite_stops_its_robot(self):
        def spoil(robots):
            speeds = numpy.full(len(robots), 2.0)
            if robots.tick == 1:
                speeds[17] = numpy.nan
            robots.commands["footbot_wheels"].left = speeds
            robots.commands["footbot_wheels"].right = speeds

        simulation = simulate(spoil)
        simulation.tick(3)
        self.assertEqual([failure["robot"] for failure in simulation.failures], ["fb_18"])
        self.assertEqual(len(simulation.robots), 100)

    def test_robots_of_a_step_are_of_that_step(self):
        kept = []
        simulation = simulate(kept.append)
        simulation.tick()
        with self.assertRaisesRegex(RuntimeError, "an earlier tick"):
            kept[0].poses

    def test_cannot_make_ticks_in_a_tick(self):
        simulation = simulate(lambda robots: simulation.tick())
        with self.assertRaisesRegex(RuntimeError, "is making ticks"):
            simulation.tick()

    def test_an_interrupt_ends_the_ticks_and_stops_no_robot(self):
        main = threading.main_thread().ident
        simulation = simulate(lambda robots: robots.tick == 20 and signal.pthread_kill(main, signal.SIGINT))
        with self.assertRaises(KeyboardInterrupt):
            simulation.tick(1000)
        self.assertLess(simulation.ticks, 1000)
        self.assertEqual(simulation.failures, [])

    def test_must_be_known_and_callable(self):
        with self.assertRaisesRegex(swarmanoid.ExperimentError, "found the controller 'drive', allowed: dc"):
            swarmanoid.Simulation("diffusion", controllers={"drive": wander})
        with self.assertRaisesRegex(TypeError, "found a controller 7, allowed"):
            simulate(7)

    def test_what_its_init_throws_refuses_the_experiment(self):
        class Controller:
            def init(self, parameters):
                raise KeyError("no gain")

            def step(self, robots):
                pass

        with self.assertRaisesRegex(KeyError, "no gain"):
            simulate(Controller())


if __name__ == "__main__":
    unittest.main()

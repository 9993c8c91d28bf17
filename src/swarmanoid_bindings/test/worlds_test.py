#!/usr/bin/python3
"""Many worlds of one experiment: runs equal to single ones, bit for bit, on any number of threads; resets, ends, robots that
come and go, mistakes."""

import pathlib
import unittest

import numpy
import swarmanoid
from swarmanoid import ExperimentError, Worlds

DIFFUSION = pathlib.Path(__file__).resolve().parents[2] / "swarmanoid_experiments/experiments/diffusion.xml"
SEEN = ["footbot_proximity.value"]
WHEELS = ["footbot_wheels.left", "footbot_wheels.right"]
SEVEN = {"arena.distribute.quantity": 7, "arena.size": (4.3, 3.9, 1), "arena.distribute.minimum": (0.2, 0.2, 0),
         "arena.distribute.maximum": (4.1, 3.7, 0)}
TICKS = 157


def policy(observations):
    """Turns while an obstacle is near: (..., 2) for (..., 24)."""
    near = observations.max(axis=-1) > 0
    return numpy.stack([numpy.where(near, -3.25, 4.5), numpy.where(near, 3.0, 4.25)], axis=-1).astype(numpy.float32)


def controller(robots):
    actions = policy(robots.readings["footbot_proximity"].value)
    robots.commands["footbot_wheels"].left, robots.commands["footbot_wheels"].right = actions.T


def single(seed, overrides=None, ticks=TICKS):
    run = swarmanoid.Simulation("diffusion", seed=seed, controllers={"dc": controller}, overrides=overrides or SEVEN)
    run.tick(ticks)
    return run


def worlds(count, **others):
    return Worlds("diffusion", count, **{"observations": SEEN, "actions": WHEELS, "overrides": SEVEN, **others})


HOLE = """<ahss-config>
  <framework><clocktick>100</clocktick><maxclock>500</maxclock></framework>
  <controllers>
    <diffusion id="dc" library="diffusion">
      <actuators><footbot_wheels/></actuators><sensors><footbot_proximity/></sensors>
    </diffusion>
  </controllers>
  <arena size="3,3,1" optimization="2D">
    <footbot id="a"><position>1, 0.9, 0</position><orientation>0, 0, 0</orientation><controller>dc</controller></footbot>
    <footbot id="b"><position>0.2, 0.12, 0</position><orientation>0, 0, 180</orientation><controller>dc</controller></footbot>
    <block id="wall"><position>0.05, 0.12, 0.1</position><orientation>0, 0, 0</orientation><size>0.05, 0.5, 0.2</size></block>
    <hole id="pit"><position>1.5, 0.9, 0</position><radius>0.15</radius></hole>
  </arena>
  <engines><kinematics2d id="ground"/></engines>
  <arena_physics><engine id="ground"><entity id="a"/><entity id="b"/><entity id="wall"/></engine></arena_physics>
</ahss-config>"""


class WorldsTest(unittest.TestCase):
    def test_each_world_is_the_run_of_its_seed(self):
        for engine, threads in (("kinematics2d", 1), ("kinematics2d", 3), ("dynamics2d", 2)):
            with self.subTest(engine=engine, threads=threads):
                text = DIFFUSION.read_text().replace("kinematics2d", engine)
                many = Worlds(text=text, count=21, observations=SEEN, actions=WHEELS, overrides=SEVEN, seed=40, threads=threads)
                for _ in range(TICKS):
                    many.step(policy(many.observations))
                for world in (0, 8, 20):
                    run = swarmanoid.Simulation(text=text, seed=40 + world, controllers={"dc": controller}, overrides=SEVEN)
                    run.tick(TICKS)
                    self.assertEqual(run.state_hash, many.state_hash(world))
                    self.assertTrue((run.robots.poses == many.poses[world]).all())
                self.assertEqual(21, len({many.state_hash(world) for world in range(21)}))

    def test_several_ticks_a_step_and_a_value_for_each_world(self):
        many = worlds(3, ticks_per_step=4, seed=9, overrides={**SEVEN, "framework.clocktick": [50, 80, 110]})
        once = [policy(many.observations[world]) for world in range(3)]
        many.step(numpy.stack(once))
        for world, clocktick in enumerate((50, 80, 110)):
            def same(robots, actions=once[world]):
                robots.commands["footbot_wheels"].left, robots.commands["footbot_wheels"].right = actions.T
            run = swarmanoid.Simulation("diffusion", seed=9 + world, controllers={"dc": same},
                                        overrides={**SEVEN, "framework.clocktick": clocktick})
            run.tick(4)
            self.assertEqual(run.state_hash, many.state_hash(world))

    def test_observations_are_in_place_and_those_of_the_next_tick(self):
        many = worlds(2, seed=3)
        seen, present = many.observations, many.present
        self.assertEqual(((2, 7, 24), numpy.float32), (seen.shape, seen.dtype))
        many.step(policy(seen))
        run = single(4, ticks=1)
        run.sense()
        self.assertTrue((run.robots.readings["footbot_proximity"].value == seen[1]).all(), "the array from before the step")
        self.assertTrue(present.all())
        self.assertEqual(seen.__array_interface__["data"], many.observations.__array_interface__["data"])
        del many
        self.assertEqual((2, 7, 24), (seen + 1).shape, "a view keeps the memory alive")

    def test_a_reset_starts_chosen_worlds_anew(self):
        many = worlds(4, seed=1)
        for _ in range(20):
            many.step(policy(many.observations))
        before = [many.state_hash(world) for world in range(4)]
        many.reset([False, True, False, True], seeds=[0, 71, 0, 72])
        for _ in range(TICKS):
            many.step(policy(many.observations))
        self.assertEqual(single(71).state_hash, many.state_hash(1))
        self.assertEqual(single(72).state_hash, many.state_hash(3))
        self.assertEqual(single(1, ticks=TICKS + 20).state_hash, many.state_hash(0))
        many.reset()   # each takes its last seed plus the number of worlds
        for _ in range(TICKS):
            many.step(policy(many.observations))
        self.assertEqual(single(1 + 4).state_hash, many.state_hash(0))
        self.assertEqual(single(71 + 4).state_hash, many.state_hash(1))
        self.assertNotIn(many.state_hash(2), before)

    def test_ends_and_resets_by_itself(self):
        for autoreset in ("next_step", "same_step", "disabled"):
            with self.subTest(autoreset=autoreset):
                many = worlds(2, seed=5, ticks=6, autoreset=autoreset)
                for _ in range(5):
                    many.step(policy(many.observations))
                    self.assertFalse(many.truncated.any())
                last = single(6, ticks=5)
                many.step(policy(many.observations))
                self.assertTrue(many.truncated.all())
                self.assertFalse(many.terminated.any())
                if autoreset == "same_step":
                    last.tick()
                    self.assertEqual(single(5 + 2, ticks=0).state_hash, many.state_hash(0))
                    readings = last.robots.readings["footbot_proximity"].value
                    self.assertTrue(readings.any())
                    self.assertTrue((many.final_observations[1] == readings).all())
                    many.step(policy(many.observations))
                    self.assertFalse(many.final_observations.any())
                    self.assertEqual(single(5 + 2, ticks=1).state_hash, many.state_hash(0))
                else:
                    ended = many.state_hash(1)
                    self.assertEqual(single(6, ticks=6).state_hash, ended)
                    self.assertIsNone(many.final_observations)
                    many.step(policy(many.observations))
                    self.assertEqual(autoreset == "disabled", bool(many.truncated.all()))
                    expected = ended if autoreset == "disabled" else single(6 + 2, ticks=0).state_hash
                    self.assertEqual(expected, many.state_hash(1))

    def test_robots_that_are_gone_are_masked(self):
        many = Worlds(text=HOLE, count=2, observations=SEEN, actions=WHEELS, autoreset="disabled")
        self.assertTrue(many.present.all())
        actions = numpy.zeros((2, 2, 2))
        actions[1, 0] = 5.0                                   # robot a of world 1 drives into the hole
        for _ in range(60):
            many.step(actions)
        self.assertEqual([[True, True], [False, True]], many.present.tolist())
        self.assertFalse(many.observations[1, 0].any() or many.poses[1, 0].any())
        self.assertTrue(many.observations[:, 1].any(axis=1).all(), "robot b is at the wall")
        self.assertEqual([False, False], many.terminated.tolist())
        many.reset([False, True])
        self.assertTrue(many.present.all())

    def test_arrays_that_are_copies_are_read_only(self):
        many = worlds(2)
        for array in (many.poses, many.twists, many.ticks, many.state):
            with self.assertRaisesRegex(ValueError, "read-only"):
                array[0] = 1

    def test_a_metric_rewards(self):
        many = Worlds("aggregation", 2, observations=["footbot_camera.overflowed"], actions=WHEELS, seed=2,
                      reward="dispersion.second_moment", overrides={"arena.distribute.quantity": 5})
        rewards = [numpy.zeros(many.rewards.shape)]
        for turn in range(30):
            many.step(numpy.full((2, 5, 2), [3.0, 3.0 + 0.1 * turn]))
            rewards.append(many.rewards.copy())
        for world in range(2):
            def same(robots):
                robots.commands["footbot_wheels"].left, robots.commands["footbot_wheels"].right = 3.0, numpy.float32(3.0 + 0.1 * robots.tick)
            run = swarmanoid.Simulation("aggregation", seed=2 + world, controllers={"ac": same},
                                        overrides={"arena.distribute.quantity": 5})
            first = run.metrics["dispersion.second_moment"]
            run.tick(30)
            self.assertEqual(run.state_hash, many.state_hash(world))
            self.assertAlmostEqual(run.metrics["dispersion.second_moment"] - first, sum(rewards)[world, 0], delta=0.01)
            self.assertTrue((sum(rewards)[world] == sum(rewards)[world, 0]).all(), "all robots of a world get the same")

    def test_mistakes_are_named(self):
        for others, text in (({"observations": ["footbot_proximty.value"]}, "did you mean 'footbot_proximity'?"),
                             ({"observations": ["footbot_wheels.left"]}, "the device 'footbot_wheels'"),
                             ({"actions": ["footbot_wheels.rigt"]}, "did you mean 'footbot_wheels.right'?"),
                             ({"actions": []}, "actions: found no fields, allowed: one or more"),
                             ({"observations": ["imu.turn_rate"]}, "imu.turn_rate', allowed: imu.angular_velocity, imu.linear"),
                             ({"observations": ["imu.angular_velocity"]}, "found the device 'imu', which the controller does not list"),
                             ({"controller": "cd"}, "the controller 'cd', allowed: dc"),
                             ({"reward": "none.at_all"}, "the metric 'none.at_all'"),
                             ({"autoreset": "next_sep"}, "did you mean 'next_step'?"),
                             ({"count": 0}, "count: found 0, allowed: from 1 to 1000000"),
                             ({"threads": 0}, "threads: found 0, allowed: from 1 to 1024"),
                             ({"ticks_per_step": 0}, "ticks_per_step: found 0, allowed: from 1"),
                             ({"overrides": {"framework.clocktick": [1, 2, 3]}}, "found 3 values, allowed: one for each of 2 worlds")):
            with self.subTest(text), self.assertRaises((ExperimentError, ValueError)) as raised:
                worlds(**{"count": 2, **others})
            self.assertIn(text, str(raised.exception))
        many = worlds(2)
        for call in (lambda: many.step(numpy.zeros((2, 7, 3))), lambda: many.reset([True]), lambda: many.reset(seeds=[1, 2, 3])):
            with self.assertRaisesRegex(ValueError, "found the shape .*, allowed: "):
                call()
        with self.assertRaises(IndexError):
            many.state_hash(2)


if __name__ == "__main__":
    unittest.main()

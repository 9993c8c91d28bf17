#!/usr/bin/python3
"""Many worlds with the interface of Gymnasium's VectorEnv: runs equal to single ones, rewards, ends and their masks, mistakes."""

import unittest

import numpy
import swarmanoid
from swarmanoid.environments import AutoresetMode, Box, Env, MultiDiscrete, VectorEnv

WHEELS = {"footbot_wheels.left": (-6, 6), "footbot_wheels.right": (-6, 6)}
SEVEN = {"arena.distribute.quantity": 7, "arena.size": (4.3, 3.9, 1), "arena.distribute.minimum": (0.2, 0.2, 0),
         "arena.distribute.maximum": (4.1, 3.7, 0)}


def policy(observations):
    """Turns while an obstacle is near: (..., 2) for (..., 24)."""
    near = observations.max(axis=-1) > 0
    return numpy.stack([numpy.where(near, -3.25, 4.5), numpy.where(near, 3.0, 4.25)], axis=-1)


def ahead(swarms):
    return swarms.twists[:, :, 0]


def vector(count=3, **others):
    return VectorEnv("diffusion", count, **{"reward": ahead, "observations": ["footbot_proximity.value"], "actions": WHEELS,
                                            "overrides": SEVEN, **others})


class VectorEnvTest(unittest.TestCase):
    def test_each_world_is_an_env_of_its_seed(self):
        many = vector()
        singles = [Env("diffusion", reward=lambda robots: robots.twists[:, 0], observations=["footbot_proximity.value"],
                       actions=WHEELS, overrides=SEVEN) for _ in range(3)]
        seen, infos = many.reset(seed=11)
        for i, env in enumerate(singles):
            numpy.testing.assert_array_equal(env.reset(seed=11 + i)[0], seen[i])
        self.assertEqual([0, 0, 0], infos["ticks"].tolist())
        for _ in range(41):
            actions = policy(seen)
            seen, rewards, terminated, truncated, infos = many.step(actions)
            for i, env in enumerate(singles):
                observed, reward = env.step(actions[i].astype(numpy.float32))[:2]
                numpy.testing.assert_array_equal(observed, seen[i])
                self.assertAlmostEqual(reward, rewards[i], places=12)
                self.assertEqual(env.simulation.state_hash, many.worlds.state_hash(i))
        numpy.testing.assert_array_equal(many.state()[1], singles[1].state())
        self.assertFalse(terminated.any() or truncated.any())
        self.assertEqual([41, 41, 41], infos["ticks"].tolist())

    def test_has_the_shape_of_gymnasium(self):
        env = vector()
        self.assertEqual(((3, 7, 24), (7, 24)), (env.observation_space.shape, env.single_observation_space.shape))
        self.assertEqual(env.single_action_space, Box(numpy.full((7, 2), -6), numpy.full((7, 2), 6)))
        self.assertEqual((3, AutoresetMode.NEXT_STEP), (env.num_envs, env.metadata["autoreset_mode"]))
        observations, _ = env.reset(seed=5)
        self.assertIn(observations, env.observation_space)
        kept = observations.copy()
        returned = env.step(env.action_space.sample())
        numpy.testing.assert_array_equal(kept, observations, "observations that were returned stay")
        self.assertEqual([(3, 7, 24), (3,), (3,), (3,)], [each.shape for each in returned[:4]])
        self.assertEqual(["float32", "float64", "bool", "bool"], [each.dtype.name for each in returned[:4]])
        self.assertEqual((3, 7), env.robot_rewards.shape)
        numpy.testing.assert_allclose(returned[1], env.robot_rewards.sum(axis=1))

    def test_modes_of_autoreset(self):
        def last(seed):
            env = vector(1, seed=seed, autoreset_mode="disabled", ticks=5)
            for _ in range(5):
                seen = env.step(numpy.full((1, 7, 2), 4.0))[0]
            return seen[0]

        actions = numpy.full((2, 7, 2), 4.0)
        for mode in ("next_step", AutoresetMode.SAME_STEP, "Disabled"):
            with self.subTest(mode):
                env = vector(2, ticks=5, autoreset_mode=mode)
                env.reset(seed=21)
                for _ in range(5):
                    seen, rewards, terminated, truncated, infos = env.step(actions)
                self.assertEqual(([True, True], [False, False]), (truncated.tolist(), terminated.tolist()))
                self.assertTrue((rewards != 0).all())
                name = "coverage.area"
                if mode is AutoresetMode.SAME_STEP:
                    self.assertEqual(([True, True], [0, 0]), (infos["_final_obs"].tolist(), infos["ticks"].tolist()))
                    numpy.testing.assert_array_equal(infos["final_obs"][1], last(22))
                    numpy.testing.assert_array_equal(seen[1], vector(1, seed=24).worlds.observations[0])
                    self.assertEqual([5, 5], infos["final_info"]["ticks"].tolist())
                    self.assertTrue((infos["final_info"][name] > 0).all() and infos["final_info"][f"_{name}"].all())
                    self.assertEqual([1, 1], env.step(actions)[4]["ticks"].tolist())
                    continue
                numpy.testing.assert_array_equal(seen[1], last(22))
                self.assertTrue((infos[name] > 0).all() and infos[f"_{name}"].all())
                seen, rewards, terminated, truncated, infos = env.step(actions)
                self.assertEqual([0.0, 0.0], rewards.tolist())
                self.assertNotIn(name, infos)
                is_anew = mode == "next_step"
                self.assertEqual(([0, 0], [False] * 2) if is_anew else ([5, 5], [True] * 2),
                                 (infos["ticks"].tolist(), truncated.tolist()))
                if not is_anew:
                    env.reset(options={"reset_mask": numpy.array([False, True])})
                    self.assertEqual([5, 0], env.worlds.ticks.tolist())

    def test_rewards(self):
        seen = []

        def of_worlds(swarms):
            seen.append((swarms.actions.shape, swarms.poses.shape, swarms.present.all()))
            with self.assertRaisesRegex(ValueError, "read-only"):
                swarms.observations[0] = 0
            return [1.0, 2.0, 3.5]

        env = vector(reward=of_worlds)
        self.assertEqual([1.0, 2.0, 3.5], env.step(numpy.ones((3, 7, 2)))[1].tolist())
        self.assertEqual([((3, 7, 2), (3, 7, 7), True)], seen)
        self.assertEqual([[2.0] * 7], env.robot_rewards[1:2].tolist())
        fall = VectorEnv("aggregation", 2, reward="-dispersion.second_moment", observations=["footbot_camera.overflowed"],
                         actions=WHEELS, seed=2, overrides={"arena.distribute.quantity": 5})
        gained, moments = [], []
        for _ in range(12):
            gained.append(fall.step(numpy.full((2, 5, 2), [4.0, 3.0]))[1])
            moments.append([fall.worlds.metrics(world)["dispersion.second_moment"] for world in range(2)])
        self.assertEqual([0.0, 0.0], gained[0].tolist(), "rules measure after the first tick")
        numpy.testing.assert_allclose(sum(gained), numpy.subtract(moments[0], moments[-1]), atol=1e-3)
        self.assertGreater(abs(sum(gained)).max(), 0.1)

    def test_choices(self):
        env = vector(choices=[[4, 4], [-2, 2], [2.5, -2]])
        self.assertEqual(env.single_action_space, MultiDiscrete([3] * 7))
        other = vector()
        env.reset(seed=8)
        other.reset(seed=8)
        for _ in range(15):
            chosen = env.action_space.sample()
            self.assertIn(chosen, env.action_space)
            env.step(chosen)
            other.step(numpy.array([[4, 4], [-2, 2], [2.5, -2]])[chosen])
        self.assertEqual(other.worlds.state_hash(2), env.worlds.state_hash(2))
        with self.assertRaisesRegex(ValueError, "allowed: whole numbers from 0 to 2"):
            env.step(numpy.full((3, 7), 3))

    def test_pictures(self):
        env = vector(2, render_mode="rgb_array", camera={"window_size": (64, 48)})
        first = env.render()
        self.assertEqual([((48, 64, 3), numpy.uint8)] * 2, [(each.shape, each.dtype) for each in first])
        self.assertFalse((first[0] == first[1]).all(), "worlds differ")
        for _ in range(20):
            env.step(numpy.full((2, 7, 2), 5.0))
        self.assertFalse((first[0] == env.render()[0]).all(), "robots have moved")
        self.assertIsNone(vector(1).render())

    def test_mistakes_are_named(self):
        for others, text in (({"autoreset_mode": "sometimes"}, "autoreset_mode: found 'sometimes', allowed: next_step, same_step, disabled"),
                             ({"render_mode": "human"}, "render_mode: found 'human', allowed: rgb_array, None"),
                             ({"reward": "nothing"}, "the metric 'nothing'"),
                             ({"choices": [1, 2]}, r"choices: found the shape \(2,\), allowed: \(choices, 2\)")):
            with self.subTest(text), self.assertRaisesRegex(ValueError, text):
                vector(**others)
        with self.assertRaisesRegex(ValueError, r"reward: found the shape \(7,\), allowed: \(3, 7\) or \(3,\)"):
            vector(reward=lambda swarms: numpy.zeros(7)).step(numpy.zeros((3, 7, 2)))
        with self.assertRaisesRegex(ValueError, "found the shape"):
            vector().step(numpy.zeros((3, 7)))


if __name__ == "__main__":
    unittest.main()

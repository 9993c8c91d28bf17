#!/usr/bin/python3
"""Installed experiments as environments: each runs, is rewarded by its metric, and stands on the page of experiments."""

import pathlib
import re
import unittest

import numpy
import swarmanoid
from swarmanoid import _tasks
from swarmanoid.environments import ParallelEnv, VectorEnv, make

PAGE = pathlib.Path(__file__).resolve().parents[3] / "docs/reference/experiments.md"


class TasksTest(unittest.TestCase):
    def test_all_experiments_but_the_check_of_robots_are_tasks(self):
        self.assertEqual(set(swarmanoid.installed_experiments()) - set(_tasks.TASKS), {"conformance"})
        with self.assertRaisesRegex(ValueError, "found the experiment 'conformance', allowed: aggregation, battery_foraging, "):
            make("conformance")

    def test_the_page_states_the_reward_of_each(self):
        section = PAGE.read_text().partition("## As environments")[2]
        rows = re.findall(r"^\| `(\w+)` \| `([-\w.]+)` \| .* \| `(\w+)` \|$", section, re.MULTILINE)
        self.assertEqual([(name, task[3], task[2]) for name, task in _tasks.TASKS.items()], rows)

    def test_each_runs(self):
        for name, (_, _, controller, reward) in _tasks.TASKS.items():
            with self.subTest(name):
                env = make(name)
                observations, info = env.reset(seed=3)
                self.assertEqual(env.observation_space.shape, observations.shape)
                sign, metric = (-1, reward[1:]) if reward[0] == "-" else (1, reward)
                gained, first = 0.0, None
                for step in range(12):
                    observations, each, terminated, _, info = env.step(env.action_space.sample())
                    first = info[metric] if first is None else first
                    gained += each
                    self.assertIn(observations, env.observation_space)
                    self.assertFalse(terminated)
                self.assertEqual(env.simulation.ticks, 12)
                self.assertAlmostEqual(gained, sign * (info[metric] - first) * len(env.names), places=3)
                self.assertEqual({controller}, set(env._world.robots().controllers))

    def test_other_kinds_and_options(self):
        parallel = make("phototaxis", ParallelEnv, ticks=7)
        parallel.reset(seed=2)
        self.assertEqual(parallel.simulation.max_ticks, 7)
        many = make("aggregation", VectorEnv, num_envs=2, overrides={"arena.distribute.quantity": 3})
        self.assertEqual((2, 3, 8), many.reset(seed=1)[0].shape)
        one = make("diffusion", reward=lambda robots: 1.5, overrides={"arena.distribute.quantity": 3})
        self.assertEqual(4.5, one.step(numpy.zeros((3, 2)))[1])


if __name__ == "__main__":
    unittest.main()

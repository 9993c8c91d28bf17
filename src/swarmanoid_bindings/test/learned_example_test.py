#!/usr/bin/python3
"""The example of learning: a policy becomes an experiment whose controller does the same as the policy in an environment."""

import pathlib
import sys
import types
import unittest

import numpy
import swarmanoid
from swarmanoid.environments import VectorEnv

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[3] / "examples/learned_swarms"))
import policy_file  # noqa: E402
import tasks        # noqa: E402


def layer(random, inputs, outputs):
    """Weights and biases as PyTorch has them."""
    return types.SimpleNamespace(weight=random.normal(size=(outputs, inputs)).round(3), bias=random.normal(size=outputs).round(3),
                                 out_features=outputs)


class LearnedExampleTest(unittest.TestCase):
    def test_a_policy_runs_as_a_controller(self):
        for name, kind in tasks.TASKS.items():
            with self.subTest(name):
                task, random = kind(), numpy.random.default_rng(3)
                actions = {**tasks.WHEELS, **{field: (value, value) for field, value in task.constants.items()}}
                env = VectorEnv(task.experiment, 1, reward=task.reward, observations=task.observations, actions=actions,
                                overrides=task.overrides, autoreset_mode="disabled")
                first, last = layer(random, env.observation_space.shape[2], 5), layer(random, 5, 2)
                text = policy_file.experiment_with(task, [first, None, last, None])
                run = swarmanoid.Simulation(text=text, seed=8)
                constants = env.single_action_space.low[:, 2:]
                seen, _ = env.reset(seed=8)
                task.begin(env.worlds)
                for _ in range(25):
                    hidden = numpy.tanh(seen[0].astype(float) @ first.weight.T + first.bias)
                    wheels = 1 / (1 + numpy.exp(-(hidden @ last.weight.T + last.bias)))
                    seen = env.step(numpy.concatenate([(2 * wheels - 1) * tasks.FASTEST, constants], axis=1)[None])[0]
                    run.tick()
                self.assertEqual(20, len(run.robots))
                numpy.testing.assert_allclose(run.robots.poses, env.worlds.poses[0], atol=1e-4)
                start = swarmanoid.Simulation(text=text, seed=8).robots.poses
                self.assertGreater(abs(run.robots.poses - start).max(), 0.1)
                self.assertEqual((1, 20), numpy.shape(task.known(env.worlds.poses))[:2])
                self.assertIn(task.metric, run.metrics)


if __name__ == "__main__":
    unittest.main()

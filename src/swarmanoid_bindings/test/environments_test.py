#!/usr/bin/python3
"""Environments: the interfaces of Gymnasium and PettingZoo, and runs equal to those of controllers, bit for bit."""

import os
import tempfile
import unittest

import numpy
import swarmanoid
from swarmanoid import Delete
from swarmanoid.environments import Box, Env, ParallelEnv

WHEELS = {"footbot_wheels.left": (-6, 6), "footbot_wheels.right": (-6, 6)}
FEW = {"arena.distribute.quantity": 30}
WRITES_A_TABLE = """<ahss-config>
  <framework><clocktick>100</clocktick><maxclock>20</maxclock></framework>
  <controllers>
    <diffusion id="dc" library="diffusion">
      <actuators><footbot_wheels/></actuators><sensors><footbot_proximity/></sensors><parameters><speed>0.1</speed></parameters>
    </diffusion>
  </controllers>
  <arena size="3,3,1" optimization="2D">
    <footbot id="fb"><position>1, 1, 0</position><orientation>0, 0, 0</orientation><controller>dc</controller></footbot>
  </arena>
  <engines><kinematics2d id="ground"/></engines>
  <arena_physics><engine id="ground"><entity id="fb"/></engine></arena_physics>
  <visualisations><text_render id="table"><file>poses.txt</file></text_render></visualisations>
</ahss-config>"""


def policy(observations):
    """Turns while an obstacle is near: (robots, 2) for (robots, 24)."""
    near = observations.max(axis=1) > 0
    return numpy.stack([numpy.where(near, -3.0, 4.0), numpy.where(near, 3.0, 4.0)], axis=1)


def speed(robots):
    return numpy.hypot(*robots.twists[:, :2].T)


def options(**others):
    return {"reward": speed, "observations": ["footbot_proximity.value"], "actions": WHEELS, "overrides": FEW, **others}


class EnvironmentsTest(unittest.TestCase):
    def test_a_policy_makes_the_run_of_a_controller(self):
        def controller(robots):
            actions = policy(robots.readings["footbot_proximity"].value)
            robots.commands["footbot_wheels"].left, robots.commands["footbot_wheels"].right = actions.T

        run = swarmanoid.Simulation("diffusion", seed=5, controllers={"dc": controller}, overrides=FEW)
        env = Env("diffusion", **options())
        parallel = ParallelEnv("diffusion", **options())
        seen, _ = env.reset(seed=5)
        by_agent, _ = parallel.reset(seed=5)
        for _ in range(120):
            run.tick()
            seen, reward, terminated, truncated, info = env.step(policy(seen))
            chosen = {agent: policy(each[None])[0] for agent, each in by_agent.items()}
            by_agent, rewards, _, _, _ = parallel.step(chosen)
            self.assertEqual(env.simulation.state_hash, run.state_hash)
            self.assertEqual(parallel.simulation.state_hash, run.state_hash)
            self.assertAlmostEqual(reward, sum(rewards.values()))
            self.assertFalse(terminated or truncated)
        self.assertGreater(reward, 0.5)
        self.assertEqual(info["ticks"], 120)

    def test_has_the_shape_of_gymnasium(self):
        env = Env("diffusion", **options())
        observation, info = env.reset(seed=3)
        self.assertEqual((env.observation_space.shape, env.action_space.shape), ((30, 24), (30, 2)))
        self.assertIn(observation, env.observation_space)
        self.assertEqual(observation.dtype, env.observation_space.dtype)
        self.assertEqual(info["ticks"], 0)
        first = env.action_space.sample()
        self.assertIn(first, env.action_space)
        observation, reward, terminated, truncated, info = env.step(first)
        self.assertIn(observation, env.observation_space)
        self.assertEqual([type(each) for each in (reward, terminated, truncated, info)], [float, bool, bool, dict])
        env.reset(seed=3)
        numpy.testing.assert_array_equal(env.action_space.sample(), first)
        again = env.step(first)
        numpy.testing.assert_array_equal(again[0], observation)
        self.assertEqual(again[1:], (reward, terminated, truncated, info))
        env.reset()
        self.assertEqual(env.simulation.seed, 4)
        self.assertIs(env.unwrapped, env)
        self.assertIsNone(env.render())
        env.close()

    def test_has_the_shape_of_pettingzoo(self):
        env = ParallelEnv("diffusion", **options(ticks=4, ticks_per_step=2))
        observations, infos = env.reset(seed=2)
        self.assertEqual(list(observations), env.agents)
        self.assertEqual(env.agents, env.possible_agents)
        self.assertEqual((env.num_agents, env.max_num_agents), (30, 30))
        self.assertIs(env.observation_space("fb_1"), env.observation_space("fb_1"))
        for agent in env.agents:
            self.assertIn(observations[agent], env.observation_space(agent))
        self.assertEqual(env.state().shape, (30, 24))
        for last in (False, True):
            before = list(env.agents)
            returned = env.step({agent: env.action_space(agent).sample() for agent in env.agents})
            for each in returned:
                self.assertEqual(list(each), before)
            self.assertEqual(set(returned[2].values()), {False})
            self.assertEqual(set(returned[3].values()), {last})
        self.assertEqual(env.agents, [])
        env.reset()
        self.assertEqual(len(env.agents), 30)

    def test_agents_that_are_gone_or_stop_are_terminated(self):
        class Thief:
            def before_tick(self, world):
                if world.ticks == 2:
                    world.ask(Delete("fb_4"))

        env = ParallelEnv("diffusion", **options(rules={"thief": Thief()}))
        env.reset(seed=2)
        ended = []
        for i in range(5):
            actions = {agent: numpy.ones(2) for agent in env.agents}
            if i == 3:
                actions["fb_7"] = [numpy.nan, 1]
            _, rewards, terminations, _, _ = env.step(actions)
            ended.append([agent for agent, is_over in terminations.items() if is_over])
        self.assertEqual([each for each in ended if each], [["fb_4"], ["fb_7"]])
        self.assertEqual(len(env.agents), 28)

    def test_a_rule_terminates_and_maxclock_truncates(self):
        class Enough:
            def after_tick(self, world):
                self.ticks = world.ticks

            def finished(self):
                return getattr(self, "ticks", 0) >= 3

            def metrics(self):
                return {"ticks": getattr(self, "ticks", 0)}

        env = Env("diffusion", **options(rules={"enough": Enough()}))
        env.reset(seed=1)
        self.assertEqual([env.step(numpy.zeros((30, 2)))[2:4] for _ in range(3)], [(False, False)] * 2 + [(True, False)])
        info = env.step(numpy.zeros((30, 2)))[4]
        self.assertEqual((info["ticks"], info["enough.ticks"]), (3, 3.0))

    def test_observers_write_into_the_folder_of_the_run(self):
        for kind in (Env, ParallelEnv):
            with self.subTest(kind.__name__), tempfile.TemporaryDirectory() as folder:
                env = kind(text=WRITES_A_TABLE, out=folder, **options(overrides={}))
                env.simulation.tick(3)
                env.close()
                with open(os.path.join(folder, "poses.txt")) as table:
                    self.assertEqual(sum(not line.startswith("#") for line in table), 4)
                with self.assertRaisesRegex(swarmanoid.ExperimentError, "poses.txt.* which is there already"):
                    kind(text=WRITES_A_TABLE, out=folder, **options(overrides={}))

    def test_mistakes_are_refused(self):
        with self.assertRaisesRegex(ValueError, "found the field 'footbot_wheels.lft', allowed: footbot_wheels.left, footbot_wheels.right"):
            Env("diffusion", **options(actions=["footbot_wheels.lft"]))
        with self.assertRaisesRegex(KeyError, "found the device 'footbot_wheel'"):
            Env("diffusion", **options(actions=["footbot_wheel.left"]))
        with self.assertRaisesRegex(ValueError, "found no fields"):
            Env("diffusion", **options(observations=[]))
        with self.assertRaisesRegex(ValueError, "controller: found none, allowed: ec, fc"):
            Env("object_retrieval", **options(overrides={}))
        with self.assertRaisesRegex(ValueError, "ticks_per_step: found 0"):
            Env("diffusion", **options(ticks_per_step=0))
        env = Env("diffusion", **options())
        env.reset(seed=1)
        with self.assertRaisesRegex(ValueError, r"actions: found the shape \(2,\), allowed: \(30, 2\)"):
            env.step([1, 2])
        parallel = ParallelEnv("diffusion", **options(reward=lambda robots: [1, 2]))
        parallel.reset(seed=1)
        with self.assertRaisesRegex(ValueError, "actions: found those of fb_1, allowed: of fb_1, fb_2"):
            parallel.step({"fb_1": [1, 1]})
        with self.assertRaisesRegex(ValueError, r"reward: found the shape \(2,\), allowed: a number, or \(30,\)"):
            parallel.step({agent: [1, 1] for agent in parallel.agents})

    def test_boxes(self):
        box = Box([0, -numpy.inf, -numpy.inf, 1], [1, numpy.inf, 0, numpy.inf], seed=1)
        for _ in range(50):
            self.assertIn(box.sample(), box)
        self.assertNotIn(numpy.array([2, 0, 0, 1], numpy.float32), box)
        self.assertNotIn(numpy.zeros(3, numpy.float32), box)
        self.assertFalse(box.is_bounded())
        self.assertEqual(Box([0], [1]), Box([0], [1]))
        self.assertNotEqual(Box([0], [1]), Box([0], [2]))
        with self.assertRaisesRegex(ValueError, "found bounds"):
            Box([1], [0])


if __name__ == "__main__":
    unittest.main()

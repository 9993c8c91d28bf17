#!/usr/bin/python3
"""Environments: the interfaces of Gymnasium and PettingZoo, and runs equal to those of controllers, bit for bit."""

import os
import tempfile
import unittest

import numpy
import swarmanoid
from swarmanoid import Delete, Move
from swarmanoid.environments import Box, Discrete, Env, ParallelEnv

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

    def test_actions_keep_their_precision(self):
        speeds = numpy.full((30, 2), 1 / 3)                     # no number in single precision

        def controller(robots):
            robots.commands["footbot_wheels"].left, robots.commands["footbot_wheels"].right = speeds.T

        run = swarmanoid.Simulation("diffusion", seed=6, controllers={"dc": controller}, overrides=FEW)
        run.tick(3)
        env = Env("diffusion", **options())
        env.reset(seed=6)
        for _ in range(3):
            env.step(speeds)
        self.assertEqual(env.simulation.state_hash, run.state_hash)
        env.simulation.tick(2)
        run.tick(2)
        self.assertEqual(env.simulation.state_hash, run.state_hash, "ticks of the simulation repeat the actions")
        env.simulation.apply(Move("fb_3", (5, 5, 0), heading=1.25))
        self.assertEqual([5, 5], env.state()[2, 1:3].tolist())
        self.assertEqual(6, env.step(speeds)[4]["ticks"])

    def test_robots_are_chosen_by_number(self):
        env = ParallelEnv("diffusion", **options(choices=[[4, 4], [-2.5, 2.5]]))
        plain = ParallelEnv("diffusion", **options())
        env.reset(seed=3)
        plain.reset(seed=3)
        self.assertEqual(env.action_space("fb_2"), Discrete(2))
        for _ in range(9):
            chosen = {agent: env.action_space(agent).sample() for agent in env.agents}
            env.step(chosen)
            plain.step({agent: [[4, 4], [-2.5, 2.5]][number] for agent, number in chosen.items()})
        self.assertEqual(env.simulation.state_hash, plain.simulation.state_hash)
        with self.assertRaisesRegex(ValueError, "allowed: whole numbers from 0 to 1"):
            env.step({agent: 2 for agent in env.agents})

    def test_the_state_is_that_of_the_whole_world(self):
        env = ParallelEnv("foraging", **options(overrides={}, actions=WHEELS, state="world"))
        env.reset(seed=4)
        env.step({agent: [3, 5] for agent in env.agents})
        state, entities = env.state(), env.simulation.entities
        self.assertEqual((4 + 6, 14), state.shape)
        places = [entities.names.index(name) for name in env.possible_agents + [f"prey_{i}" for i in range(1, 7)]]
        numpy.testing.assert_array_equal(state[:, 1:8], entities.poses[places])
        numpy.testing.assert_array_equal(state[:, 8:], entities.twists[places])
        self.assertTrue((state[:, 0] == 1).all() and state[:4, 8:].any())
        env.simulation.apply(Delete("fb_2"))
        self.assertFalse(env.state()[1].any())
        with self.assertRaisesRegex(ValueError, "state: found 'all', allowed: observations, world"):
            ParallelEnv("foraging", **options(overrides={}, state="all"))

    def test_lists_are_read_by_direction(self):
        fields = ["footbot_camera.blobs.distance[sectors=6 near maximum=2.5 colors=yellow,green]",
                  "footbot_camera.blobs.bearing[count=2]", "footbot_camera.blobs.distance[sectors=3 maximum=4]"]
        env = Env("foraging", **options(observations=fields, overrides={}))
        self.assertEqual(([0] * 12 + [-1] * 2 + [0] * 3, [1] * 17),
                         (env.observation_space.low[0].tolist(), env.observation_space.high[0].tolist()))
        env.reset(seed=5)
        seen = env.step(numpy.full((4, 2), [2, 3]))[0]
        env.simulation.sense()
        blobs = env.simulation.robots.readings["footbot_camera"].blobs
        expected = numpy.zeros((4, 17))
        for robot in range(4):
            mine = blobs.robot == robot
            bearing, distance = blobs.bearing[mine].astype(float), blobs.distance[mine].astype(float)
            red, green = blobs.color.red[mine], blobs.color.green[mine]
            for k in range(len(bearing)):
                sector = int(numpy.floor(bearing[k] / (2 * numpy.pi / 6) + 0.5)) % 6
                third = int(numpy.floor(bearing[k] / (2 * numpy.pi / 3) + 0.5)) % 3
                place = sector + (0 if red[k] == 255 else 6)
                if green[k] == 255:
                    expected[robot, place] = max(expected[robot, place], 1 - min(distance[k], 2.5) / 2.5)
                expected[robot, 14 + third] = max(expected[robot, 14 + third], min(distance[k], 4) / 4)
            expected[robot, 12:12 + min(2, len(bearing))] = bearing[:2] / numpy.pi
        numpy.testing.assert_allclose(seen, expected, rtol=1e-6)
        self.assertGreater(numpy.count_nonzero(seen[:, 6:12]), 0, "the nest is in sight")

    def test_mistakes_in_lists_are_named(self):
        camera = "footbot_camera.blobs.distance"
        for field, text in ((camera, rf"which is in a list, allowed: {camera}\[sectors=8\]"),
                            (f"{camera}[sectors=8]", "distance: found values .*, allowed: with minimum and maximum"),
                            (f"{camera}[maximum=2]", "allowed: with either count or sectors"),
                            (f"{camera}[sectors=1 maximum=2]", "sectors: found '1', allowed: a whole number from 2 to 1000"),
                            (f"{camera}[sectors=4 maximum=2 colors=pink]", "colors: found 'pink'"),
                            (f"{camera}[sectors=4 maximum=2 nere]", "did you mean 'near'"),
                            ("footbot_camera.blobs.distnce[sectors=4]", "did you mean 'footbot_camera.blobs.distance'")):
            with self.subTest(field), self.assertRaisesRegex(ValueError, text):
                Env("foraging", **options(observations=[field], overrides={}))

    def test_a_metric_rewards(self):
        env = Env("aggregation", **options(reward="-dispersion.second_moment", observations=["footbot_camera.overflowed"],
                                           overrides={"arena.distribute.quantity": 5}))
        env.reset(seed=7)
        actions = numpy.full((5, 2), [4.0, 3.0])
        self.assertEqual(0.0, env.step(actions)[1], "rules measure after the first tick")
        before = env.simulation.metrics["dispersion.second_moment"]
        rewards = [env.step(actions)[1] for _ in range(6)]
        self.assertAlmostEqual(5 * (before - env.simulation.metrics["dispersion.second_moment"]), sum(rewards), places=9)
        with self.assertRaisesRegex(ValueError, "reward: found the metric 'dispersion', allowed: dispersion.largest_cluster, "):
            Env("aggregation", **options(reward="dispersion", observations=["footbot_camera.overflowed"], overrides={}))

    def test_pictures(self):
        env = Env("diffusion", **options(render_mode="rgb_array", camera={"window_size": (64, 48)}))
        before = env.render()
        self.assertEqual(((48, 64, 3), numpy.uint8), (before.shape, before.dtype))
        numpy.testing.assert_array_equal(before, env.render())
        for _ in range(30):
            env.step(numpy.full((30, 2), 6.0))
        self.assertTrue((before != env.render()).any())
        with self.assertRaisesRegex(ValueError, "render_mode: found 'human', allowed: rgb_array, None"):
            Env("diffusion", **options(render_mode="human"))

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

#!/usr/bin/python3
"""Snapshots in Python: state of Python controllers and rules, forks, many worlds, and refusals."""

import copy
import threading
import unittest

import numpy
import swarmanoid
from swarmanoid import Simulation, Worlds

FIVE = {"arena.distribute.quantity": 5, "arena.size": (1.9, 2.1, 1), "arena.distribute.minimum": (0.2, 0.2, 0),
        "arena.distribute.maximum": (1.7, 1.9, 0)}


class Weaving:
    """Turns for a while where an obstacle is near; of all robots at once, with state."""

    def __init__(self):
        self.turns_left = numpy.zeros(5, int)
        self.steps = 0

    def step(self, robots):
        near = robots.readings["footbot_proximity"].value.max(axis=1) > 0
        self.turns_left[near & (self.turns_left == 0)] = 3 + self.steps % 4
        turning = self.turns_left > 0
        self.turns_left[turning] -= 1
        self.steps += 1
        wheels = robots.commands["footbot_wheels"]
        wheels.left, wheels.right = numpy.where(turning, -3.0, 4.5), numpy.where(turning, 3.25, 4.0 + 0.01 * (self.steps % 7))


class Alone:
    """The same for one robot."""

    def init(self, robot, parameters):
        self.robot, self.values = robot, robot.readings["footbot_proximity"].value
        self.turns_left = 0
        self.memory = {"steps": 0}

    def step(self, robot):
        self.memory["steps"] += 1
        if self.turns_left == 0 and max(self.values) > 0:
            self.turns_left = 2 + self.memory["steps"] % 5
        wheels = robot.commands["footbot_wheels"]
        if self.turns_left > 0:
            self.turns_left -= 1
            wheels.left, wheels.right = -3.0, 3.5
        else:
            wheels.left, wheels.right = 4.5, 4.25


class Counting:
    """A rule that moves a robot away at times that its own count decides."""

    def __init__(self):
        self.count = 0

    def metrics(self):
        return {"count": self.count}

    def after_tick(self, world):
        self.count += 1
        if self.count % 17 == 0:
            world.try_to(swarmanoid.Move("fb_2", (0.3 + 0.02 * (self.count % 50), 0.3, 0)))


def straight(robots):
    robots.commands["footbot_wheels"].left = robots.commands["footbot_wheels"].right = numpy.full(len(robots.names), 4.0)


class SnapshotTest(unittest.TestCase):
    def test_runs_go_on_with_the_state_of_python_controllers_and_rules(self):
        for controller in (Weaving, lambda: Alone, lambda: straight):
            for ticks in (1, 23, 71):
                with self.subTest(controller=controller, ticks=ticks):
                    run = Simulation("diffusion", seed=ticks, overrides=FIVE, controllers={"dc": controller()},
                                     rules={"counting": Counting()})
                    run.tick(ticks)
                    snapshot = run.snapshot()
                    self.assertEqual((ticks, ticks), (snapshot.ticks, snapshot.seed))
                    fork = run.fork()
                    hashes = [run.tick() and run.state_hash for _ in range(60)]
                    metrics = run.metrics
                    self.assertEqual(ticks + 60, metrics["counting.count"])
                    run.restore(snapshot)
                    self.assertEqual(ticks, run.ticks)
                    self.assertEqual(hashes, [run.tick() and run.state_hash for _ in range(60)])
                    self.assertEqual(metrics, run.metrics)
                    self.assertEqual(hashes, [fork.tick() and fork.state_hash for _ in range(60)])

    def test_robots_that_were_deleted_and_added_come_back(self):
        run = Simulation("diffusion", seed=8, overrides=FIVE, controllers={"dc": Alone})
        run.tick(31)
        run.apply(swarmanoid.Delete("fb_3"))
        run.tick(12)
        snapshot = run.snapshot()
        run.tick(25)
        expected = run.state_hash
        run.reset(4)
        run.tick(3)
        run.restore(snapshot)
        self.assertEqual(["fb_1", "fb_2", "fb_4", "fb_5"], list(run.robots.names))
        run.tick(25)
        self.assertEqual(expected, run.state_hash)

    def test_a_snapshot_in_many_worlds(self):
        options = dict(observations=["footbot_proximity.value"], actions=["footbot_wheels.left", "footbot_wheels.right"],
                       overrides=FIVE, threads=2)
        worlds = Worlds("diffusion", 6, seed=2, **options)
        actions = numpy.random.default_rng(5).uniform(-4, 7, (90, 6, 5, 2)).astype(numpy.float32)
        for each in actions[:37]:
            worlds.step(each)
        snapshot, seen = worlds.snapshot(4), worlds.observations[4].copy()
        others = [worlds.state_hash(world) for world in range(6)]
        worlds.restore(snapshot, [True, False, True, False, False, True])
        self.assertEqual([others[4], others[1], others[4], others[3], others[4], others[4]],
                         [worlds.state_hash(world) for world in range(6)])
        self.assertTrue((worlds.observations[[0, 2, 5]] == seen).all())
        single = Worlds("diffusion", 1, seed=6, **options)
        for each in actions[:37]:
            single.step(each[4:5])
        for each in actions[37:]:
            worlds.step(numpy.broadcast_to(each[1], (6, 5, 2)))
            single.step(each[1:2])
        self.assertEqual({single.state_hash(0)}, {worlds.state_hash(world) for world in (0, 2, 4, 5)})
        self.assertNotEqual(single.state_hash(0), worlds.state_hash(1))

    def test_one_snapshot_in_several_threads(self):
        run = Simulation("diffusion", seed=12, overrides=FIVE)
        run.tick(40)
        snapshot = run.snapshot()
        run.tick(50)
        found = []

        def go_on():
            other = Simulation("diffusion", seed=1, overrides=FIVE)
            for _ in range(20):
                other.restore(snapshot)
                other.tick(50)
                found.append(other.state_hash)
        threads = [threading.Thread(target=go_on) for _ in range(3)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual([run.state_hash] * 60, found)

    def test_what_is_refused(self):
        diffusion = Simulation("diffusion", overrides=FIVE)
        snapshot = diffusion.snapshot()
        with self.assertRaisesRegex(swarmanoid.ExperimentError, "found a snapshot with controller 'dc' of libdiffusion.so, "
                                    "allowed: one of the same experiment, with controller 'pc' of libphototaxis.so there"):
            Simulation("phototaxis").restore(snapshot)
        weaving = Simulation("diffusion", overrides=FIVE, controllers={"dc": Weaving()})
        before = weaving.state_hash
        worlds = Worlds("diffusion", observations=["footbot_proximity.value"], actions=["footbot_wheels.left"], overrides=FIVE)
        with self.assertRaisesRegex(swarmanoid.ExperimentError, "controller 'dc' of all its robots is another one"):
            weaving.restore(worlds.snapshot(0))
        self.assertEqual(before, weaving.state_hash)
        weaving.tick(2)
        with self.assertRaisesRegex(IndexError, "found the world 1, allowed: less than 1"):
            worlds.snapshot(1)
        with self.assertRaisesRegex(RuntimeError, r"dynamics3d\) does not define its state"):
            Simulation("climbing").snapshot()
        locked = Weaving()
        locked.lock = threading.Lock()
        run = Simulation("diffusion", overrides=FIVE, controllers={"dc": locked})
        with self.assertRaisesRegex(RuntimeError, "the state of .*Weaving object.*cannot pickle '_thread.lock' object"):
            run.snapshot()
        run.tick(3)
        with self.assertRaisesRegex(TypeError, "a Snapshot cannot be copied or pickled"):
            copy.copy(snapshot)


if __name__ == "__main__":
    unittest.main()

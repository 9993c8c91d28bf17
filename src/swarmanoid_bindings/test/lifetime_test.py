#!/usr/bin/python3
"""Validity of objects, objects that cannot be copied, and release of memory."""

import copy
import gc
import pickle
import subprocess
import sys
import unittest
import weakref

import swarmanoid
from swarmanoid import Delete, Move, Simulation, Spawn
from swarmanoid.environments import Env


def small():
    return Simulation("diffusion", seed=2, overrides={"arena.distribute.quantity": 4})


class KeptObjectsTest(unittest.TestCase):
    def test_what_was_got_before_a_tick_is_refused_in_its_first_callback(self):
        refusals = []

        def look(kept):
            for use in (lambda: kept.poses, lambda: kept.names, lambda: kept.readings["footbot_proximity"].value):
                with self.assertRaisesRegex(RuntimeError, "robots of an earlier tick"):
                    use()
                refusals.append(use)

        class Rule:
            kept = None

            def before_tick(self, world):
                if self.kept is not None:
                    look(self.kept)

        rule = Rule()
        simulation = Simulation("diffusion", seed=2, overrides={"arena.distribute.quantity": 4}, rules={"keeps": rule},
                                controllers={"dc": lambda robots: look(rule.kept) if rule.kept is not None else None})
        for number in range(5):
            rule.kept = simulation.robots
            rule.kept.readings["footbot_proximity"].value
            simulation.apply(Delete(rule.kept.names[0]))
            simulation.apply(Spawn("footbot", f"new_{number}", (0.5 + 0.3 * number, 0.5, 0.0), engines=["ground"], controller="dc"))
            rule.kept = rule.kept if number % 2 == 0 else simulation.robots
            simulation.tick()
        self.assertGreaterEqual(len(refusals), 5 * 3)


class CopiesTest(unittest.TestCase):
    def parts(self):
        simulation = small()
        robots = simulation.robots
        devices = robots.readings
        arrays = devices["footbot_proximity"]
        return simulation, robots, devices, arrays

    def test_copies_are_refused_in_words(self):
        ways = [copy.copy, copy.deepcopy, *(lambda value, protocol=protocol: pickle.dumps(value, protocol)
                                             for protocol in range(pickle.HIGHEST_PROTOCOL + 1))]
        for part in self.parts():
            for way in ways:
                with self.assertRaisesRegex(TypeError, f"a {type(part).__name__} cannot be copied or pickled: "):
                    way(part)

    def test_an_object_without_its_constructor_is_refused(self):
        _, _, devices, arrays = parts = self.parts()
        for part in parts:
            unmade = type(part).__new__(type(part))
            uses = {Simulation: (lambda: unmade.tick(), lambda: unmade.state_hash, lambda: unmade.robots, lambda: unmade.close()),
                    swarmanoid.Robots: (lambda: unmade.poses, lambda: len(unmade), lambda: unmade.take([0])),
                    type(devices): (lambda: unmade["footbot_proximity"], lambda: list(unmade), lambda: len(unmade)),
                    type(arrays): (lambda: unmade.value, lambda: setattr(unmade, "value", 1), lambda: repr(unmade))}[type(part)]
            for use in uses:
                with self.assertRaisesRegex(TypeError, "has not been made"):
                    use()
            del unmade
            gc.collect()
        with self.assertRaisesRegex(TypeError, "has not been made"):
            repr(Move.__new__(Move))

    def test_a_subclass_that_uses_itself_too_early_is_refused(self):
        class Early(Simulation):
            def __init__(self):
                self.tick()
                super().__init__("diffusion")

        with self.assertRaisesRegex(TypeError, r"super\(\).__init__\(\)"):
            Early()

        class Late(Simulation):
            def __init__(self):
                super().__init__("diffusion", seed=2)
                self.tick()

        self.assertEqual(Late().ticks, 1)

    def test_interventions_can_be_copied(self):
        move = Move("fb_1", (1.0, 2.0, 0.0))
        for copied in (copy.copy(move), copy.deepcopy(move), pickle.loads(pickle.dumps(move))):
            self.assertEqual(copied, move)


class GarbageTest(unittest.TestCase):
    def assert_given_back(self, make):
        owner = make()
        seen = weakref.ref(owner)
        del owner
        gc.collect()
        self.assertIsNone(seen())

    def test_simulations_whose_parts_know_them_are_given_back(self):
        class Part:
            def step(self, robots):
                pass

            def after_tick(self, world):
                pass

        def with_controller():
            part = Part()
            part.simulation = Simulation("diffusion", controllers={"dc": part})
            part.simulation.tick()
            return part

        def with_function():
            part = Part()
            part.simulation = Simulation("diffusion", controllers={"dc": lambda robots: part})
            part.simulation.tick()
            return part

        def with_rule():
            part = Part()
            part.simulation = Simulation("diffusion", rules={"rule": part})
            part.simulation.tick()
            return part

        def with_class():
            class Single:
                def step(self, robot):
                    pass

            Single.simulation = Simulation("diffusion", controllers={"dc": Single})
            Single.simulation.tick(2)
            return Single

        for make in (with_controller, with_function, with_rule, with_class):
            with self.subTest(make.__name__):
                self.assert_given_back(make)

    def test_what_is_in_use_is_kept(self):
        class Part:
            def step(self, robots):
                steps.append(robots.tick)

        steps = []
        part = Part()
        part.simulation = Simulation("diffusion", controllers={"dc": part})
        simulation = part.simulation
        del part
        gc.collect()
        simulation.tick(3)
        self.assertEqual(steps, [0, 1, 2])

    def test_environments_are_given_back(self):
        def closed():
            env = Env("diffusion", reward=lambda robots: robots.poses[:, 0], observations=["footbot_proximity.value"],
                      actions={"footbot_wheels.left": (-5, 5), "footbot_wheels.right": (-5, 5)})
            env.reset(seed=3)
            env.step(env.action_space.sample())
            env.close()
            return env

        self.assert_given_back(closed)


class EndTest(unittest.TestCase):
    """Python ends while a daemon thread ticks."""

    PROGRAM = """
import atexit, threading, time
{first}
import swarmanoid
def idle(robots):
    {work}
simulation = swarmanoid.Simulation("diffusion", seed=2, threads={threads}, controllers={{"dc": idle}} if {in_python} else {{}})
def go():
    while True:
        simulation.tick({ticks})
threading.Thread(target=go, daemon=True).start()
time.sleep({seconds})
"""

    def end(self, ticks=1, seconds=0.3, in_python=False, work="pass", threads=1, first=""):
        program = self.PROGRAM.format(ticks=ticks, seconds=seconds, in_python=in_python, work=work, threads=threads,
                                      first=first)
        done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, timeout=60, check=False)
        self.assertEqual((done.returncode, done.stderr), (0, ""))

    def test_a_thread_that_ticks_does_not_abort_it(self):
        for seconds in (0.1, 0.2, 0.3):
            with self.subTest(seconds=seconds):
                self.end(seconds=seconds)
                self.end(seconds=seconds, ticks=10**9)
                self.end(seconds=seconds, ticks=10**9, in_python=True)
                self.end(seconds=seconds, ticks=10**9, threads=2)

    def test_a_controller_that_ticks_another_simulation_comes_to_its_end(self):
        self.end(ticks=10**9, in_python=True, work="swarmanoid.Simulation('phototaxis', seed=1).tick(20)")

    def test_the_last_lines_of_a_program_may_tick(self):
        # registered before the module's exit handler, so called after that handler has waited for ticks
        self.end(first="atexit.register(lambda: swarmanoid.Simulation('phototaxis', seed=1).tick(20))")


if __name__ == "__main__":
    unittest.main()

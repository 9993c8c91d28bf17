#!/usr/bin/python3
"""Python rules: the order of their calls, their interventions, and handling of their errors."""

import concurrent.futures
import gc
import pickle
import unittest

import numpy
import swarmanoid
from swarmanoid import Delete, Move, SetProperty


class Diary:
    """Records its calls."""

    def __init__(self):
        self.calls = []

    def init(self, parameters):
        self.calls.append(("init", parameters))

    def reset(self, world):
        self.calls.append(("reset", world.ticks))

    def before_tick(self, world):
        self.calls.append(("before_tick", world.ticks))

    def after_tick(self, world):
        self.calls.append(("after_tick", world.ticks))


class Shepherd:
    """Moves a robot back to the middle once it is too far, if the place is free; scores by the mean distance."""

    def reset(self, world):
        self.returns = 0
        self.distance = 0.0

    def after_tick(self, world):
        offset = world.robots.poses[:, :2] - [2.5, 1.5]
        distance = numpy.hypot(*offset.T)
        self.distance = distance.mean()
        far = int(distance.argmax())
        if distance[far] > 0.95:
            x, y = world.uniform(2.2, 2.8), world.gaussian(1.5, 0.1)
            world.try_to(Move(world.robots.names[far], (x, y, 0), heading=world.uniform(0, 6)))
            self.returns += 1

    def metrics(self):
        return {"returns": getattr(self, "returns", 0), "distance": getattr(self, "distance", 0)}

    def finished(self):
        return self.returns >= 12

    def success(self):
        return self.returns > 3


def simulate(rules, **options):
    return swarmanoid.Simulation("phototaxis", rules=rules, **options)


class RulesTest(unittest.TestCase):
    def test_is_called_where_rules_in_cpp_are(self):
        diary = Diary()
        seen = []
        simulation = simulate({"diary": diary}, controllers={"pc": lambda robots: seen.append(len(diary.calls))})
        simulation.tick(2)
        self.assertEqual(diary.calls, [("init", {}), ("reset", 0), ("before_tick", 0), ("after_tick", 1),
                                       ("before_tick", 1), ("after_tick", 2)])
        self.assertEqual(seen, [3, 5])
        simulation.reset()
        self.assertEqual(diary.calls[6:], [("reset", 0)])

    def test_asks_for_interventions_and_scores(self):
        simulation = simulate({"shepherd": Shepherd()}, seed=4)
        result = simulation.run()
        self.assertEqual(simulation.metrics["shepherd.returns"], 12)
        self.assertGreater(simulation.metrics["shepherd.distance"], 0.1)
        self.assertIn("lamps.switches", simulation.metrics)
        self.assertEqual((result["finished"], result["success"]), (True, True))
        self.assertLess(result["ticks"], 3000)
        self.assertIn({"kind": "finished", "entity": "", "other": "", "text": "rule 'shepherd' ends the run"}, simulation.events)
        again = simulate({"shepherd": Shepherd()}, seed=4, threads=3).run()
        self.assertEqual(again, result)
        simulation.reset()
        self.assertEqual(simulation.run(), result)
        self.assertNotEqual(simulate({"shepherd": Shepherd()}, seed=5).run()["state_hash"], result["state_hash"])

    def test_threads_of_one_process_make_the_same_runs(self):
        def run(seed):
            return simulate({"shepherd": Shepherd()}, seed=seed, controllers={"pc": wander}, ticks=300).run()

        def wander(robots):
            robots.commands["footbot_wheels"].left = robots.uniform(0.0, 6.0)
            robots.commands["footbot_wheels"].right = robots.uniform(0.0, 6.0)

        alone = [run(seed) for seed in range(1, 7)]
        self.assertEqual(len({result["state_hash"] for result in alone}), 6)
        with concurrent.futures.ThreadPoolExecutor(4) as pool:
            self.assertEqual(list(pool.map(run, range(1, 7))), alone)

    def test_what_before_tick_asks_for_is_done_before_sensing(self):
        class Thief:
            def before_tick(self, world):
                if world.ticks == 1:
                    world.ask(Delete("fb_2"))

        seen = []
        simulation = simulate({"thief": Thief()}, controllers={"pc": lambda robots: seen.append(len(robots))})
        simulation.tick(3)
        self.assertEqual(seen, [4, 3, 3])
        self.assertEqual(simulation.interventions, [])
        again = simulate({"thief": Thief()})
        again.tick(2)
        self.assertIn(("rule 'thief'", Delete("fb_2")), again.interventions)

    def test_stands_in_the_place_of_a_rule_of_the_file(self):
        diary = Diary()
        simulation = simulate({"lamps": diary})
        self.assertEqual(diary.calls[0][1]["lamp"], "west")
        self.assertEqual(simulation.metrics, {})

    def test_what_it_throws_ends_the_run(self):
        class Faulty:
            def __init__(self, hook, tick):
                def fail(world=None):
                    if not isinstance(world, swarmanoid.World) or world.ticks == tick:
                        raise ZeroDivisionError("no robots left")
                setattr(self, hook, fail)

        for hook, tick in (("before_tick", 4), ("after_tick", 5)):
            with self.subTest(hook):
                simulation = simulate({"score": Faulty(hook, tick)})
                message = f"^rule 'score', {hook}: ZeroDivisionError: no robots left \\(.*:\\d+\\)$"
                with self.assertRaisesRegex(swarmanoid.RuleError, message) as caught:
                    simulation.tick(10)
                self.assertIsInstance(caught.exception.__cause__, ZeroDivisionError)
                self.assertIsInstance(caught.exception, RuntimeError)
                self.assertEqual((simulation.ticks, simulation.finished, simulation.result["finished"]), (tick, True, False))
                self.assertEqual(simulation.tick(), 0)
                self.assertEqual(simulation.robots.poses.shape, (4, 7))
                simulation.reset()
                self.assertEqual(simulation.tick(2), 2)
        for hook in ("init", "reset", "metrics"):
            with self.subTest(hook), self.assertRaisesRegex(swarmanoid.RuleError, f"rule 'score', {hook}: ZeroDivisionError"):
                simulate({"score": Faulty(hook, 0)})

    def test_what_it_asks_for_in_vain_ends_the_run_and_what_it_tries_does_not(self):
        class Asks:
            def __init__(self, how):
                self.how = how

            def after_tick(self, world):
                getattr(world, self.how)(Move("fb_9", (1, 1, 0)))

        simulation = simulate({"mover": Asks("ask")})
        with self.assertRaisesRegex(RuntimeError, "rule 'mover' asked in tick 1 for what is refused: there is no entity 'fb_9'"):
            simulation.tick(5)
        self.assertTrue(simulation.finished)
        simulation = simulate({"mover": Asks("try_to")})
        self.assertEqual(simulation.tick(5), 5)
        self.assertTrue(any("there is no entity 'fb_9'" in event["text"] for event in simulation.events))

    def test_gets_an_answer_to_what_it_asks(self):
        answers = []

        class Mover:
            def reset(self, world):
                answers.append(world.ask(Move("fb_2", (2.5, 2.0, 0))))

            def before_tick(self, world):
                if world.ticks == 1:
                    answers.append(world.try_to(Move("fb_1", (2.5, 2.0, 0))))   # occupied by fb_2

            def after_tick(self, world):
                if world.ticks == 2:
                    answers.append(world.try_to(Delete("fb_1")))
                    answers.append(world.try_to(Move("fb_1", (1, 1, 0))))
                    seen.append([answer.done for answer in answers])

        seen = []
        simulation = simulate({"mover": Mover()})
        simulation.tick(2)
        self.assertEqual(seen, [[True, False, None, None]])
        self.assertEqual(repr(answers[2]), "<Answer: pending>")
        simulation.tick()
        self.assertEqual([answer.done for answer in answers], [True, False, True, False])
        self.assertEqual([answer.refusal for answer in answers],
                         ["", "footbot 'fb_1' in engine 'ground': overlaps 'fb_2'", "", "there is no entity 'fb_1'; did you mean 'fb_2'?"])
        self.assertEqual(repr(answers[0]), "<Answer: done>")
        self.assertEqual(repr(answers[3]), "<Answer: refused: there is no entity 'fb_1'; did you mean 'fb_2'?>")
        with self.assertRaisesRegex(TypeError, "a Answer cannot be copied or pickled: it is of one request"):
            pickle.dumps(answers[0])

    def test_metrics_keep_their_names_and_are_numbers(self):
        class Moody:
            ticks = 0
            value = 1.0

            def after_tick(self, world):
                self.ticks = world.ticks

            def metrics(self):
                return {"mood": self.value} if self.ticks < 3 else {"humour": 1.0}

        simulation = simulate({"moody": Moody()})
        with self.assertRaisesRegex(swarmanoid.RuleError, "rule 'moody', metrics: KeyError: 'mood'"):
            simulation.tick(5)
        Moody.value = "fine"
        with self.assertRaisesRegex(swarmanoid.RuleError, "metrics: TypeError: must be real number, not str"):
            simulate({"moody": Moody()})

    def test_the_world_is_that_of_the_call(self):
        kept = []

        class Keeper:
            def after_tick(self, world):
                kept.append(world)

        simulation = simulate({"keeper": Keeper()})
        simulation.tick()
        for look in (lambda: kept[0].ticks, lambda: kept[0].robots, lambda: kept[0].uniform(),
                     lambda: kept[0].ask(Delete("fb_1"))):
            with self.assertRaisesRegex(RuntimeError, "an earlier tick"):
                look()
        del simulation
        gc.collect()
        with self.assertRaisesRegex(RuntimeError, "an earlier tick"):
            kept[0].ticks

    def test_cannot_write_commands_or_make_ticks(self):
        class Meddler:
            def after_tick(self, world):
                world.robots.commands["footbot_wheels"].left = 1.0

        with self.assertRaisesRegex(swarmanoid.RuleError, "footbot_wheels.left is not written here"):
            simulate({"meddler": Meddler()}).tick()

        class Runner:
            def before_tick(self, world):
                simulation.apply(SetProperty("west", "intensity", 1))

        simulation = simulate({"runner": Runner()})
        with self.assertRaisesRegex(swarmanoid.RuleError, "is making ticks"):
            simulation.tick()

    def test_what_is_none_is_refused(self):
        for value in (7, Diary, object()):
            with self.assertRaisesRegex(TypeError, "found a rule .*, allowed: an object with functions of init, reset"):
                simulate({"rule": value})


if __name__ == "__main__":
    unittest.main()

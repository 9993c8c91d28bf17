#!/usr/bin/python3
"""Evolutions without workers: the best genotype, and rejected input."""

import itertools
import unittest
from unittest import mock

from swarmanoid_studies import evolution
from swarmanoid_studies.mistakes import BadInput, RunsStopped
from swarmanoid_studies.runs import RunOutcome, lost
from swarmanoid_studies.study import Gene, Objective, OptimiserChoice, Study

SEEDS = (3, 8)
STUDY = Study("study", "world.xml", {"a.b": "7"}, (Gene("x", -1.0, 3.0, "study.xml:4"),), SEEDS,
              (Objective("height", False, "study.xml:6"),), OptimiserChoice("ga", {"random_seed": 1, "population": 6, "crossover": 0.9,
                                                                                  "mutation": 0.0}))


def done(height):
    return RunOutcome({"height": height}, None, 10, 0.1, "00", "", True)


class EvolutionTest(unittest.TestCase):
    def step(self, own, outcome_of):
        """@param outcome_of maps a request to its outcome"""
        def outcomes(_client, requests, count):
            made = [(number, outcome_of(request)) for number, request in itertools.islice(requests, count)]
            return reversed(made)  # the last one finishes first
        with mock.patch.object(evolution, "outcomes", outcomes):
            own.take(own.make(None, lambda outcome: None))

    def test_fitness_is_the_mean_over_the_seeds_and_the_greatest_is_kept(self):
        own = evolution.Evolution(STUDY, "world.xml")
        heights = {}

        def run(request):
            values = dict(request.overrides)
            self.assertEqual((request.experiment, values["a.b"]), ("world.xml", "7"))
            x = float(values["x"])
            self.assertTrue(-1.0 <= x <= 3.0)
            heights.setdefault(x, {})[request.seed] = -x * x + 0.125 * request.seed
            return done(heights[x][request.seed])

        for _ in range(3):
            self.step(own, run)
        self.assertTrue(all(set(of) == set(SEEDS) for of in heights.values()))
        means = {x: sum(of.values()) / len(SEEDS) for x, of in heights.items()}
        best, = own.best
        self.assertEqual(STUDY.genes[0].value(best.genotype[0]), max(means, key=means.get))
        self.assertEqual(best.values, (max(means.values()),))

    def test_of_equal_ones_the_oldest_is_kept(self):
        own = evolution.Evolution(STUDY, "world.xml")
        for _ in range(3):
            self.step(own, lambda request: done(1.5))
        self.assertEqual((own.best[0].generation, own.best[0].index), (1, 0))

    def test_a_run_without_a_result_ends_it_after_the_last_whole_generation(self):
        own = evolution.Evolution(STUDY, "world.xml")
        self.step(own, lambda request: done(1.0))
        with self.assertRaisesRegex(RunsStopped, r"^generation 2: a run has no result: it died \(a\.b=7, x=.*, seed 3\)$"):
            self.step(own, lambda request: lost("it died") if request.seed == 3 else done(1.0))
        self.assertEqual(len(own.generations), 1)

    def test_runs_in_which_controllers_failed_are_named(self):
        own = evolution.Evolution(STUDY, "world.xml")
        text = "1 controllers failed, first fb_1 in tick 5: it is tired"
        self.step(own, lambda request: done(1.0)._replace(failure=text if request.seed == 8 else ""))
        generation, = own.generations
        self.assertEqual(generation.failed_controllers, 6)
        self.assertEqual(generation.first_failures, [f"genotype {i}, seed 8: {text}" for i in range(6)])

    def test_a_checkpoint_of_other_genotypes_is_refused(self):
        own = evolution.Evolution(STUDY, "world.xml")
        self.step(own, lambda request: done(1.0))
        first, = own.generations
        evolution.Evolution(STUDY, "world.xml").replay([first])
        other = first._replace(genotypes=[[0.5], *first.genotypes[1:]])
        with self.assertRaisesRegex(BadInput, "^generation 1 of the checkpoint: found other genotypes than the optimiser asks for"):
            evolution.Evolution(STUDY, "world.xml").replay([other])


if __name__ == "__main__":
    unittest.main()

#!/usr/bin/python3
"""Optimisers: they find optima, and ask for the same genotypes again after the same losses."""

import random
import unittest

import numpy
from swarmanoid_studies.optimisers import front, make_optimiser, reflected
from swarmanoid_studies.study import OptimiserChoice
from swarmanoid_studies.study_file import OPTIMISERS

TARGET = (0.2, 0.7, 0.4)


def choice(kind, **parameters):
    return OptimiserChoice(kind, {**{name: bounds.default for name, bounds in OPTIMISERS[kind].items()}, **parameters})


def loss(genotype):
    return sum((value - target) ** 2 for value, target in zip(genotype, TARGET))


def losses(kind, population):
    return [(loss(each),) if kind != "nsga2" else (loss(each), each[0]) for each in population]


class OptimisersTest(unittest.TestCase):
    def evolve(self, kind, generations, disturb=lambda: None, **parameters):
        optimiser = make_optimiser(choice(kind, **parameters), len(TARGET), 2 if kind == "nsga2" else 1)
        asked = []
        for _ in range(generations):
            disturb()
            asked.append(optimiser.ask())
            disturb()
            optimiser.tell(losses(kind, asked[-1]))
        return asked

    def test_find_the_minimum(self):
        for kind, generations in (("cma_es", 60), ("ga", 60), ("nsga2", 60)):
            for seed in (1, 2, 3):
                asked = self.evolve(kind, generations, random_seed=seed)
                first, last = (min(map(loss, population)) for population in (asked[0], asked[-1]))
                self.assertLess(last, 2e-3, kind)
                self.assertLess(last, first)

    def test_stay_in_the_ranges(self):
        for kind in OPTIMISERS:
            for population in self.evolve(kind, 20, **({"sigma": 3.0} if kind == "cma_es" else {})):
                for genotype in population:
                    self.assertTrue(all(0.0 <= value <= 1.0 for value in genotype))

    def test_depend_on_their_seed_alone(self):
        """Also if other code draws from the global generators, as Dask does in threads."""
        def disturb():
            random.random()
            numpy.random.random(3)

        for kind in OPTIMISERS:
            self.assertEqual(self.evolve(kind, 12), self.evolve(kind, 12, disturb), kind)
            self.assertNotEqual(self.evolve(kind, 1), self.evolve(kind, 1, random_seed=2), kind)

    def test_leave_the_generators_of_the_process_alone(self):
        random.seed(5)
        expected = random.random()
        random.seed(5)
        self.evolve("nsga2", 3)
        self.evolve("ga", 3)
        self.assertEqual(random.random(), expected)

    def test_what_is_not_finite_is_the_worst(self):
        for kind in OPTIMISERS:
            optimiser = make_optimiser(choice(kind), len(TARGET), 2 if kind == "nsga2" else 1)
            for _ in range(40):
                asked = optimiser.ask()
                optimiser.tell([(float("inf"),) * len(values) if genotype[0] > 0.5 else values
                                for genotype, values in zip(asked, losses(kind, asked))])
            self.assertLess(min(map(loss, optimiser.ask())), 0.01, kind)

    def test_reflection(self):
        for value, expected in ((0.25, 0.25), (-0.25, 0.25), (1.25, 0.75), (2.25, 0.25), (-1.25, 0.75), (1.0, 1.0)):
            self.assertEqual(reflected(value), expected)

    def test_the_front_is_what_nothing_is_better_than(self):
        self.assertEqual(front([(3.0, 1.0), (1.0, 3.0), (2.0, 2.0), (2.5, 2.5), (3.0, 3.0)]), [1, 2, 0])
        self.assertEqual(front([(2.0,), (1.0,), (float("inf"),)]), [1])


if __name__ == "__main__":
    unittest.main()

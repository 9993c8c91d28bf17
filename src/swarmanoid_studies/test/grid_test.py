#!/usr/bin/python3
"""Parsing of seeds and values of the command line."""

import tracemalloc
import unittest

from swarmanoid_studies.grid import Axis, Requests, parse_axis, parse_grid
from swarmanoid_studies.mistakes import BadInput
from swarmanoid_studies.seeds import parse_seeds


class GridTest(unittest.TestCase):
    def refused(self, message, function, *arguments):
        with self.assertRaises(BadInput) as caught:
            function(*arguments)
        self.assertEqual(str(caught.exception), message)

    def test_seeds_are_numbers_and_ranges(self):
        self.assertEqual(list(parse_seeds("3")), [3])
        self.assertEqual(list(parse_seeds("1..4, 9,7")), [1, 2, 3, 4, 9, 7])
        self.assertEqual(list(parse_seeds("18446744073709551615")), [2 ** 64 - 1])

    def test_each_seed_has_a_place(self):
        seeds = parse_seeds("20..24,3,18446744073709551614..18446744073709551615,4..6")
        listed = list(seeds)
        self.assertEqual(len(seeds), 11)
        self.assertEqual([seeds[place] for place in range(11)], listed)
        self.assertEqual([seeds.place(seed) for seed in listed], list(range(11)))
        self.assertEqual([seeds.place(seed) for seed in (0, 2, 7, 19, 25, 2 ** 64 - 3)], [None] * 6)

    def test_millions_of_runs_take_no_memory(self):
        tracemalloc.start()
        self.addCleanup(tracemalloc.stop)
        requests = Requests(parse_grid("1..999999,2000000..2000000", ["a=1,2,3,4,5", "b=x,y"]), "gap", {})
        self.assertEqual(len(requests), 10_000_000)
        last = requests[9_999_999]
        self.assertEqual((last.overrides, last.seed), ((("a", "5"), ("b", "y")), 2_000_000))
        self.assertEqual(requests.number(("5", "y"), "2000000"), 9_999_999)
        self.assertLess(tracemalloc.get_traced_memory()[1], 100_000)

    def test_other_seeds_are_refused(self):
        for text in ("", "x", "1..", "4..1", "-1", "1.5", "18446744073709551616", "1,,2"):
            self.refused(f"--seeds: found '{text}', allowed: seeds and ranges of seeds, such as 1..1000 or 1,2,10..20",
                         parse_seeds, text)
        self.refused("--seeds: found '2' twice, allowed: once", parse_seeds, "1..3,2")
        self.refused("--seeds: found 20000000 seeds, allowed: up to 10000000", parse_seeds, "1..20000000")

    def test_values_are_split_at_commas(self):
        self.assertEqual(parse_axis("a.b=1, 2,x y"), Axis("a.b", ("1", "2", "x y")))
        self.assertEqual(parse_axis(r"arena.size=5\, 3\, 2,6\,3\,2"), Axis("arena.size", ("5, 3, 2", "6,3,2")))
        self.assertEqual(parse_axis("a=b=c"), Axis("a", ("b=c",)))

    def test_other_values_are_refused(self):
        self.refused("--set: found 'a.b', allowed: path=value or path=value,value,...", parse_axis, "a.b")
        self.refused("--set: found 'a.b=1\\n', allowed: printable characters", parse_axis, "a.b=1\n")
        self.refused("--set a.b: found '1' twice, allowed: once", parse_axis, "a.b=1,2,1")
        self.refused("--set: found 'framework.random_seed=1,2', allowed: --seeds for seeds", parse_axis, "framework.random_seed=1,2")
        self.refused("--set: found 'a.b' twice, allowed: once", parse_grid, "1", ["a.b=1", "a.b=2"])
        self.refused("found 100000000 runs, allowed: up to 10000000", parse_grid, "1..10000000", ["a.b=1,2,3,4,5,6,7,8,9,10"])

    def test_runs_are_all_combinations_seeds_first(self):
        grid = parse_grid("1..2", ["a=x,y", "b=1,2,3"])
        requests = Requests(grid, "gap", {"t": "5"})
        self.assertEqual(len(requests), grid.size())
        self.assertEqual([requests[number].seed for number in range(4)], [1, 2, 1, 2])
        self.assertEqual(requests[2].overrides, (("t", "5"), ("a", "x"), ("b", "2")))
        self.assertEqual(len(set(requests)), 12)
        numbers = [requests.number([value for _, value in request.overrides[1:]], str(request.seed)) for request in requests]
        self.assertEqual(numbers, list(range(12)))
        self.assertEqual([requests.number(("x", "4"), "1"), requests.number(("x", "3"), "3")], [None, None])


if __name__ == "__main__":
    unittest.main()

#!/usr/bin/python3
"""Seeds and values as they are given on the command line."""

import unittest

from swarmanoid_studies.grid import Axis, parse_axis, parse_grid, parse_seeds
from swarmanoid_studies.mistakes import BadInput


class GridTest(unittest.TestCase):
    def refused(self, message, function, *arguments):
        with self.assertRaises(BadInput) as caught:
            function(*arguments)
        self.assertEqual(str(caught.exception), message)

    def test_seeds_are_numbers_and_ranges(self):
        self.assertEqual(parse_seeds("3"), (3,))
        self.assertEqual(parse_seeds("1..4, 9,7"), (1, 2, 3, 4, 9, 7))
        self.assertEqual(parse_seeds("18446744073709551615"), (2 ** 64 - 1,))

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
        self.refused("--set a.b: found '1' twice, allowed: once", parse_axis, "a.b=1,2,1")
        self.refused("--set: found 'framework.random_seed=1,2', allowed: --seeds for seeds", parse_axis, "framework.random_seed=1,2")
        self.refused("--set: found 'a.b' twice, allowed: once", parse_grid, "1", ["a.b=1", "a.b=2"])
        self.refused("found 100000000 runs, allowed: up to 10000000", parse_grid, "1..10000000", ["a.b=1,2,3,4,5,6,7,8,9,10"])

    def test_runs_are_all_combinations_seeds_first(self):
        grid = parse_grid("1..2", ["a=x,y", "b=1,2,3"])
        requests = grid.requests("gap", {"t": "5"})
        self.assertEqual(len(requests), grid.size())
        self.assertEqual([request.seed for request in requests[:4]], [1, 2, 1, 2])
        self.assertEqual(requests[2].overrides, (("t", "5"), ("a", "x"), ("b", "2")))
        self.assertEqual(len(set(requests)), 12)


if __name__ == "__main__":
    unittest.main()

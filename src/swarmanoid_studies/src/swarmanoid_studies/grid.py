"""The runs of a batch: each combination of values with each seed."""

import itertools
import re
from typing import Dict, List, NamedTuple, Optional, Sequence, Tuple

from .contents import Contents
from .mistakes import BadInput
from .runs import RunRequest

SEED_PATH = "framework.random_seed"
MOST_RUNS = 10_000_000
LARGEST_SEED = 2 ** 64 - 1


class Axis(NamedTuple):
    """A value of the experiment file, and what it is in turn."""
    path: str
    values: Tuple[str, ...]


class Grid(NamedTuple):
    axes: Tuple[Axis, ...]
    seeds: Tuple[int, ...]

    def requests(self, experiment: str, shared: Dict[str, str], expected: Optional[Contents] = None) -> List[RunRequest]:
        """Seeds change first, so that workers keep what they have read.
        @param shared overrides of all runs @param expected what all are to be made of"""
        combinations = itertools.product(*([(axis.path, value) for value in axis.values] for axis in self.axes))
        return [RunRequest(experiment, (*shared.items(), *combination), seed, expected)
                for combination in combinations for seed in self.seeds]

    def size(self) -> int:
        size = len(self.seeds)
        for axis in self.axes:
            size *= len(axis.values)
        return size


def parse_seeds(text: str, option: str = "--seeds") -> Tuple[int, ...]:
    """Of "1..5,8": 1, 2, 3, 4, 5, 8. @raise BadInput"""
    seeds: List[int] = []
    for part in text.split(","):
        found = re.fullmatch(r"\s*(\d{1,20})\s*(?:\.\.\s*(\d{1,20})\s*)?", part, re.ASCII)
        first, last = (int(found[1]), int(found[2] or found[1])) if found else (1, 0)
        if first > last or last > LARGEST_SEED:
            raise BadInput(f"{option}: found '{text}', allowed: seeds and ranges of seeds, such as 1..1000 or 1,2,10..20")
        if last - first >= MOST_RUNS:
            raise BadInput(f"{option}: found {last - first + 1} seeds, allowed: up to {MOST_RUNS}")
        seeds.extend(range(first, last + 1))
    return tuple(_without_repeats(seeds, option))


def parse_axis(text: str) -> Axis:
    r"""Of "path=a,b,c"; a comma inside of a value is written "\,". @raise BadInput"""
    path, equals, values = text.partition("=")
    if not equals or not path:
        raise BadInput(f"--set: found '{text}', allowed: path=value or path=value,value,...")
    if path == SEED_PATH:
        raise BadInput(f"--set: found '{text}', allowed: --seeds for seeds")
    split = [value.replace("\\,", ",").strip() for value in re.split(r"(?<!\\),", values)]
    return Axis(path, tuple(_without_repeats(split, f"--set {path}")))


def parse_grid(seeds: str, settings: Sequence[str]) -> Grid:
    """@raise BadInput"""
    grid = Grid(tuple(parse_axis(setting) for setting in settings), parse_seeds(seeds))
    _without_repeats([axis.path for axis in grid.axes], "--set")
    if grid.size() > MOST_RUNS:
        raise BadInput(f"found {grid.size()} runs, allowed: up to {MOST_RUNS}")
    return grid


def _without_repeats(values: Sequence, option: str) -> Sequence:
    if len(set(values)) == len(values):
        return values
    seen = set()
    repeated = next(value for value in values if value in seen or seen.add(value))
    raise BadInput(f"{option}: found '{repeated}' twice, allowed: once")

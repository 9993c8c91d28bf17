"""The runs of a batch: each combination of values with each seed. Runs are numbered, and requests created on demand."""

import re
from typing import Dict, NamedTuple, Optional, Sequence, Tuple

from .contents_fields import Contents
from .input_file import shown
from .mistakes import BadInput
from .runs import RunRequest
from .seeds import MOST_RUNS, Seeds, parse_seeds

SEED_PATH = "framework.random_seed"


class Axis(NamedTuple):
    """A value of the experiment file that is varied, with its settings."""
    path: str
    values: Tuple[str, ...]


class Grid(NamedTuple):
    axes: Tuple[Axis, ...]
    seeds: Seeds

    def size(self) -> int:
        size = len(self.seeds)
        for axis in self.axes:
            size *= len(axis.values)
        return size


class Requests(Sequence[RunRequest]):
    """Requests for all runs of a grid, by number. Seeds vary fastest, so that workers can reuse loaded experiments."""

    def __init__(self, grid: Grid, experiment: str, shared: Dict[str, str], expected: Optional[Contents] = None) -> None:
        """@param shared overrides of all runs @param expected contents that all runs must have"""
        self._grid = grid
        self._experiment = experiment
        self._shared = tuple(shared.items())
        self._expected = expected
        self._places = [{value: place for place, value in enumerate(axis.values)} for axis in grid.axes]

    def __len__(self) -> int:
        return self._grid.size()

    def __getitem__(self, number: int) -> RunRequest:  # type: ignore[override]  # no slices
        if not 0 <= number < len(self):
            raise IndexError(number)
        combination, place = divmod(number, len(self._grid.seeds))
        chosen = []
        for axis in reversed(self._grid.axes):
            combination, value = divmod(combination, len(axis.values))
            chosen.append((axis.path, axis.values[value]))
        return RunRequest(self._experiment, (*self._shared, *reversed(chosen)), self._grid.seeds[place], self._expected)

    def number(self, values: Sequence[str], seed: str) -> Optional[int]:
        """Number of the run with these values, one per axis; None if the grid has no such run."""
        number = 0
        for places, value in zip(self._places, values):
            if value not in places:
                return None
            number = number * len(places) + places[value]
        place = self._grid.seeds.place(int(seed))
        return None if place is None else number * len(self._grid.seeds) + place


def parse_axis(text: str) -> Axis:
    r"""Parses "path=a,b,c"; a comma in a value is written "\,". @raise BadInput"""
    path, equals, values = text.partition("=")
    if not equals or not path:
        raise BadInput(f"--set: found '{shown(text)}', allowed: path=value or path=value,value,...")
    if not text.isprintable():  # a row of the CSV file is a line of UTF-8
        raise BadInput(f"--set: found '{shown(text)}', allowed: printable characters")
    if path == SEED_PATH:
        raise BadInput(f"--set: found '{shown(text)}', allowed: --seeds for seeds")
    split = [value.replace("\\,", ",").strip() for value in re.split(r"(?<!\\),", values)]
    _refuse_repeats(split, f"--set {path}")
    return Axis(path, tuple(split))


def parse_grid(seeds: str, settings: Sequence[str]) -> Grid:
    """@raise BadInput"""
    grid = Grid(tuple(parse_axis(setting) for setting in settings), parse_seeds(seeds))
    _refuse_repeats([axis.path for axis in grid.axes], "--set")
    if grid.size() > MOST_RUNS:
        raise BadInput(f"found {grid.size()} runs, allowed: up to {MOST_RUNS}")
    return grid


def _refuse_repeats(values: Sequence[str], option: str) -> None:
    """@raise BadInput"""
    seen = set()
    for value in values:
        if value in seen:
            raise BadInput(f"{option}: found '{value}' twice, allowed: once")
        seen.add(value)

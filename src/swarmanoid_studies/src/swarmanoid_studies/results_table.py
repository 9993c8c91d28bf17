"""A batch's CSV file as columns, for statistics: numbers as arrays, and repeated strings stored once."""

import array
from typing import Dict, Iterable, List, NamedTuple, Sequence, Tuple

import numpy

from .identity_fields import IDENTITY
from .input_file import NUMBER, open_file
from .mistakes import BadInput
from .results_columns import Columns
from .results_rows import RowReader

MOST_FAILURES = 100   # stored failures
TRUTH = {"true": 1.0, "false": 0.0, "": float("nan"), "nan": float("nan"), "inf": float("inf"), "-inf": float("-inf")}


class Axis(NamedTuple):
    """Values of a path."""
    values: Tuple[str, ...]   # sorted, numerically if all are numbers: the order of rows is arbitrary
    places: numpy.ndarray     # (rows,): index of the row's value in `values`


class Results(NamedTuple):
    columns: Columns
    count: int                          # number of rows
    identity: Dict[str, List[str]]      # distinct values by column, in the order of the rows
    axes: Dict[str, Axis]               # by path
    seeds: numpy.ndarray                # (rows,)
    metrics: Dict[str, numpy.ndarray]   # (rows,) each, NaN if a run lacks it; true and false are 1 and 0
    texts: Tuple[str, ...]              # names of metrics that are no numbers
    wall_s: float                       # sum over all runs [s]
    failed: int
    failures: List[Tuple[str, ...]]     # the first ones: values of the paths, seed, reason


class _Values:
    """A column of strings with few distinct values."""

    def __init__(self) -> None:
        self._places: Dict[str, int] = {}
        self._column = array.array("q")

    def add(self, value: str) -> None:
        self._column.append(self._places.setdefault(value, len(self._places)))

    def known(self) -> List[str]:
        return list(self._places)

    def axis(self) -> Axis:
        values = ordered(self._places)
        places = {value: place for place, value in enumerate(values)}
        moved = numpy.array([places[value] for value in self._places], dtype=numpy.int64)
        return Axis(values, moved[numpy.frombuffer(self._column, dtype=numpy.int64)] if self._column else numpy.empty(0, numpy.int64))


class _Numbers:
    """A column of numbers; becomes a column of strings at the first value that is no number."""

    def __init__(self) -> None:
        self.is_text = False
        self._column = array.array("d")

    def add(self, text: str) -> None:
        if not self.is_text:
            number = TRUTH.get(text)
            if number is None and not NUMBER.fullmatch(text):
                self.is_text = True
                self._column = array.array("d")
            else:
                self._column.append(float(text) if number is None else number)

    def numbers(self) -> numpy.ndarray:
        return numpy.array(self._column)


def ordered(values: Iterable[str]) -> Tuple[str, ...]:
    values = list(values)
    if all(NUMBER.fullmatch(value) for value in values):
        return tuple(sorted(values, key=lambda value: (float(value), value)))
    return tuple(sorted(values))


class _Table:
    def __init__(self, columns: Columns) -> None:
        self._columns = columns
        self._identity = {name: _Values() for name in IDENTITY}
        self._paths = {path: _Values() for path in columns.paths}
        self._seeds = array.array("Q")
        self._metrics = {name: _Numbers() for name in columns.metrics}
        self._wall_s = 0.0
        self._failed = 0
        self._failures: List[Tuple[str, ...]] = []

    def add(self, row: Sequence[str]) -> None:
        cells = iter(row)
        for values in (*self._identity.values(), *self._paths.values()):
            values.add(next(cells))
        seed, _, _, wall_s, _, failure, _ = (next(cells) for _ in range(7))
        self._seeds.append(int(seed))
        self._wall_s += float(wall_s)
        if failure:
            self._failed += 1
            if self._failed <= MOST_FAILURES:
                self._failures.append((*row[len(IDENTITY):len(IDENTITY) + len(self._paths)], seed, failure))
        for numbers, cell in zip(self._metrics.values(), cells):
            numbers.add(cell)

    def results(self) -> Results:
        return Results(self._columns, len(self._seeds), {name: values.known() for name, values in self._identity.items()},
                       {path: values.axis() for path, values in self._paths.items()}, numpy.array(self._seeds, dtype=numpy.uint64),
                       {name: column.numbers() for name, column in self._metrics.items() if not column.is_text},
                       tuple(name for name, column in self._metrics.items() if column.is_text), self._wall_s, self._failed, self._failures)


def read_results(path: str) -> Results:
    """@raise BadInput"""
    with open_file(path) as file:
        reader = RowReader(file, path)
        if reader.is_empty:
            raise BadInput(f"{path}: found no columns, allowed: a CSV file that `swarmanoid batch` has written")
        table = _Table(reader.columns)
        for _, row in reader.rows():
            table.add(row)
    results = table.results()
    _refuse_repeated_runs(path, results)
    return results


def _refuse_repeated_runs(path: str, results: Results) -> None:
    """@raise BadInput"""
    keys = [results.seeds, *(axis.places for axis in results.axes.values())]
    order = numpy.lexsort(keys)   # stable: equal keys stay in the order of their lines
    is_repeated = numpy.ones(max(0, results.count - 1), dtype=bool)
    for key in keys:
        is_repeated &= key[order][1:] == key[order][:-1]
    if is_repeated.any():
        raise BadInput(f"{path}:{2 + int(order[1:][is_repeated].min())}: found a run a second time, allowed: once")

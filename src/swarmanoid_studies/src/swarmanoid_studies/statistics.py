"""Statistics of a batch: each metric by value, and comparisons of pairs of runs with the same seed.

Intervals are 95 % confidence intervals of the mean (Student's t). The runs of a pair differ in one value only and have the same
seed, so both have the random effects of that seed. The effect size of pairs is Cohen's d_z, mean over standard deviation of the
differences; p is from Wilcoxon's signed-rank test. A report makes many such tests, and some p are small by chance, so Holm's
correction for the number of tests is also given: Holm, S. (1979), A simple sequentially rejective multiple test procedure,
Scandinavian Journal of Statistics 6, 65-70."""

import math
import warnings
from typing import Dict, Iterator, List, NamedTuple, Sequence, Tuple

import numpy
import scipy.stats

from .results_table import Results

LEVEL = 0.95
ALL = "all runs"
Panel = Tuple[str, str]   # metric, and path whose values are compared; path "": no comparison


class Summary(NamedTuple):
    """Summary of one metric for one value of a path."""
    value: str
    count: int
    mean: float
    low: float     # interval of the mean
    high: float
    median: float
    least: float
    most: float


class Comparison(NamedTuple):
    """Comparison of one metric for two values of a path, in pairs with the same seed and otherwise equal values."""
    first: str
    second: str
    pairs: int
    difference: float   # mean of second minus first
    low: float
    high: float
    effect: float       # Cohen's d_z
    p: float            # Wilcoxon
    corrected: float    # p with Holm's correction for all tests of the report


def panels(results: Results) -> List[Panel]:
    """Panels of a report, in its order."""
    paths = [path for path, axis in results.axes.items() if len(axis.values) > 1] or [""]
    return [(metric, path) for metric in results.metrics for path in paths]


def interval(values: numpy.ndarray) -> Tuple[float, float, float]:
    """@return mean and its interval, which is NaN for a single value"""
    with numpy.errstate(all="ignore"):   # sums may overflow
        mean = float(numpy.mean(values)) if len(values) else math.nan
        if len(values) < 2:
            return mean, math.nan, math.nan
        half = float(scipy.stats.t.ppf(0.5 + LEVEL / 2, len(values) - 1) * numpy.std(values, ddof=1) / len(values) ** 0.5)
        return mean, mean - half, mean + half


def groups(results: Results, path: str, metric: str) -> Iterator[Tuple[str, numpy.ndarray]]:
    """Values of a metric by value of a path, in the order of the axis. @param path "": all values in one group"""
    values = results.metrics[metric]
    is_finite = numpy.isfinite(values)
    if not path:
        yield ALL, values[is_finite]
        return
    axis = results.axes[path]
    for place, value in enumerate(axis.values):
        yield value, values[is_finite & (axis.places == place)]


def summaries(results: Results, path: str, metric: str) -> List[Summary]:
    rows = []
    for value, found in groups(results, path, metric):
        if len(found):
            with numpy.errstate(all="ignore"):
                rows.append(Summary(value, len(found), *interval(found), float(numpy.median(found)), float(found.min()),
                                    float(found.max())))
    return rows


def comparisons(results: Results) -> Dict[Panel, List[Comparison]]:
    """All comparisons of a report: for each panel with a path, each value with the first value."""
    pairs = {path: _pair_numbers(results, path) for path in results.axes}
    found = {panel: _compare(results, panel, pairs[panel[1]]) for panel in panels(results) if panel[1]}
    corrected = iter(holm([each.p for rows in found.values() for each in rows]))
    return {panel: [each._replace(corrected=next(corrected)) for each in rows] for panel, rows in found.items()}


def holm(p: Sequence[float]) -> List[float]:
    """Holm-corrected p values, which bound the probability of any false positive among all tests."""
    corrected = [0.0] * len(p)
    largest = 0.0
    for rank, index in enumerate(sorted(range(len(p)), key=p.__getitem__)):
        largest = max(largest, min(1.0, (len(p) - rank) * p[index]))
        corrected[index] = largest
    return corrected


def _pair_numbers(results: Results, path: str) -> numpy.ndarray:
    """Numbers of pairs, (rows,): equal for runs that differ only in the value of the path."""
    others = [axis.places for other, axis in results.axes.items() if other != path]
    _, seeds = numpy.unique(results.seeds, return_inverse=True)
    if not others:
        return seeds
    return numpy.unique(numpy.stack([*others, seeds], axis=1), axis=0, return_inverse=True)[1]


def _compare(results: Results, panel: Panel, pairs: numpy.ndarray) -> List[Comparison]:
    metric, path = panel
    axis, values = results.axes[path], results.metrics[metric]
    rows = [numpy.flatnonzero(numpy.isfinite(values) & (axis.places == place)) for place in range(len(axis.values))]
    found = []
    for place in range(1, len(rows)):
        _, first, second = numpy.intersect1d(pairs[rows[0]], pairs[rows[place]], assume_unique=True, return_indices=True)
        with numpy.errstate(all="ignore"):
            differences = values[rows[place][second]] - values[rows[0][first]]
        if len(differences) >= 2 and numpy.isfinite(differences).all():
            found.append(Comparison(axis.values[0], axis.values[place], len(differences), *interval(differences), _effect(differences),
                                    _wilcoxon(differences), math.nan))
    return found


def _effect(differences: numpy.ndarray) -> float:
    with numpy.errstate(all="ignore"):
        mean, deviation = float(numpy.mean(differences)), float(numpy.std(differences, ddof=1))
    if deviation > 0:
        return mean / deviation
    return math.copysign(math.inf, mean) if differences.any() else 0.0


def _wilcoxon(differences: numpy.ndarray) -> float:
    if not differences.any():
        return 1.0
    with warnings.catch_warnings():   # about few or equal pairs: p is valid, and shown with the number of pairs
        warnings.simplefilter("ignore")
        p = float(scipy.stats.wilcoxon(differences, zero_method="pratt").pvalue)
    return p if math.isfinite(p) else 1.0

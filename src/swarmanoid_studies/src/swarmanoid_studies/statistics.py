"""What the rows of a batch say: each metric by value, and pairs of runs with the same seed.

Intervals are of the mean, at 95 % (Student's t). Pairs are runs that differ in one value alone, seed included, so chance that the
seed brings is in both. The effect size of pairs is Cohen's d_z, mean over standard deviation of the differences; p is of
Wilcoxon's signed-rank test, not corrected for the number of pairs of values."""

from typing import Dict, Iterator, List, NamedTuple, Tuple

import numpy
import pandas
import scipy.stats

from .identity_fields import IDENTITY
from .mistakes import BadInput
from .results_columns import Columns, columns_of

LEVEL = 0.95
ALL = "all runs"


class Results(NamedTuple):
    rows: pandas.DataFrame     # values of paths are texts, metrics numbers or texts
    columns: Columns

    def numeric(self) -> List[str]:
        """Metrics that have a distribution: numbers, and true or false as 1 and 0."""
        return [name for name in self.columns.metrics if pandas.api.types.is_numeric_dtype(self.rows[name])]


class Summary(NamedTuple):
    """Of one metric with one value of a path."""
    value: str
    count: int
    mean: float
    low: float     # interval of the mean
    high: float
    median: float
    least: float
    most: float


class Comparison(NamedTuple):
    """Of one metric with two values of a path, in pairs of the same seed and otherwise equal values."""
    first: str
    second: str
    pairs: int
    difference: float   # second less first, mean
    low: float
    high: float
    effect: float       # Cohen's d_z
    p: float            # Wilcoxon


def read_results(path: str) -> Results:
    """@raise BadInput"""
    try:
        with open(path, encoding="utf-8", errors="replace") as file:
            columns = columns_of(file.readline().rstrip("\n").split(","), path)
        texts = {name: str for name in (*IDENTITY, *columns.paths, "success", "state_hash", "failure", "overrides", *columns.metrics)}
        rows = pandas.read_csv(path, dtype=texts, keep_default_na=False, encoding_errors="replace")
    except (OSError, ValueError) as error:
        raise BadInput(f"{path}: cannot be read: {getattr(error, 'strerror', None) or error}") from None
    for name in columns.metrics:
        rows[name] = _numbers(rows[name])
    return Results(rows, columns)


def _numbers(texts: pandas.Series) -> pandas.Series:
    """Numbers, NaN where a run has none, if all that are there are numbers; else the texts."""
    numbers = pandas.to_numeric(texts.replace({"true": "1", "false": "0", "": "nan"}), errors="coerce")
    is_text = numbers.isna() & ~texts.isin(("", "nan", "inf", "-inf"))
    return texts if is_text.any() or not len(texts) else numbers.astype(float)


def interval(values: numpy.ndarray) -> Tuple[float, float, float]:
    """@return mean, and its interval; a single value has none"""
    mean = float(numpy.mean(values)) if len(values) else float("nan")
    if len(values) < 2:
        return mean, float("nan"), float("nan")
    half = scipy.stats.t.ppf(0.5 + LEVEL / 2, len(values) - 1) * float(numpy.std(values, ddof=1)) / len(values) ** 0.5
    return mean, mean - half, mean + half


def groups(results: Results, path: str, metric: str) -> Iterator[Tuple[str, numpy.ndarray]]:
    """Values of a metric by value of a path, in the order of the file's grid. @param path "": all in one"""
    finite = results.rows[numpy.isfinite(results.rows[metric])]
    if not path:
        yield ALL, finite[metric].to_numpy()
        return
    for value in values_of(results, path):
        yield value, finite.loc[finite[path] == value, metric].to_numpy()


def values_of(results: Results, path: str) -> List[str]:
    """Numbers by size, else texts as they came first; rows are in no order."""
    values = list(dict.fromkeys(results.rows[path]))
    try:
        return sorted(values, key=float)
    except ValueError:
        return sorted(values)


def summaries(results: Results, path: str, metric: str) -> List[Summary]:
    rows = []
    for value, found in groups(results, path, metric):
        if len(found):
            rows.append(Summary(value, len(found), *interval(found), float(numpy.median(found)), float(found.min()),
                                float(found.max())))
    return rows


def comparisons(results: Results, path: str, metric: str) -> List[Comparison]:
    """Each value with the first one."""
    finite = results.rows[numpy.isfinite(results.rows[metric])]
    others = [name for name in results.columns.paths if name != path] + ["seed"]
    by_value: Dict[str, pandas.Series] = {
        value: finite[finite[path] == value].set_index(others)[metric] for value in values_of(results, path)}
    first, *rest = by_value
    found = []
    for value in rest:
        pairs = pandas.concat([by_value[first], by_value[value]], axis=1, join="inner").to_numpy()
        if len(pairs) < 2:
            continue
        differences = pairs[:, 1] - pairs[:, 0]
        deviation = float(numpy.std(differences, ddof=1))
        is_equal = not differences.any()
        p = 1.0 if is_equal else float(scipy.stats.wilcoxon(differences, zero_method="pratt").pvalue)
        effect = float(numpy.mean(differences)) / deviation if deviation > 0 else (0.0 if is_equal else float("inf"))
        found.append(Comparison(first, value, len(pairs), *interval(differences), effect, p))
    return found

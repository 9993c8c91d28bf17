"""Pictures of a batch: each metric by value, its runs as points, its mean with the interval."""

from typing import List, Tuple

import numpy
from matplotlib.axes import Axes

from .pictures import png, pyplot
from .statistics import Results, groups, interval

MOST_POINTS = 500   # shown of one value; the violin is of all
PANEL = (5.6, 3.6)  # inches


def panels(results: Results) -> List[Tuple[str, str]]:
    """Metric and path of each picture."""
    paths = [path for path in results.columns.paths if results.rows[path].nunique() > 1] or [""]
    return [(metric, path) for metric in results.numeric() for path in paths]


def draw(axes: Axes, results: Results, metric: str, path: str) -> None:
    found = [(value, values) for value, values in groups(results, path, metric) if len(values)]
    for place, (_, values) in enumerate(found):
        if len(values) > 2 and numpy.ptp(values) > 0:
            for body in axes.violinplot([values], [place], widths=0.8, showextrema=False)["bodies"]:
                body.set(facecolor="tab:blue", alpha=0.2)
        shown = values[:MOST_POINTS]
        spread = numpy.random.default_rng(0).uniform(-0.12, 0.12, len(shown))  # so that equal ones can be seen
        axes.plot(place + spread, shown, ".", color="tab:blue", alpha=0.4, markersize=3)
        mean, low, high = interval(values)
        if numpy.isfinite(low):
            axes.plot([place, place], [low, high], color="black", linewidth=2)
        axes.plot([place], [mean], "o", color="black", markersize=5)
    axes.set_xticks(range(len(found)), [value for value, _ in found], rotation=30 if len(found) > 6 else 0)
    axes.set_xlabel(path)
    axes.set_ylabel(metric)
    axes.grid(axis="y", alpha=0.3)


def picture(results: Results, metric: str, path: str) -> bytes:
    """PNG of one metric by the values of one path."""
    figure, axes = pyplot.subplots(figsize=PANEL)
    draw(axes, results, metric, path)
    return png(figure)


def all_pictures(results: Results, title: str) -> bytes:
    """PNG of all of them."""
    wanted = panels(results)
    columns = min(2, max(1, len(wanted)))
    rows = max(1, -(-len(wanted) // columns))
    figure, axes = pyplot.subplots(rows, columns, figsize=(PANEL[0] * columns, PANEL[1] * rows + 0.4), squeeze=False)
    for place in axes.flat[len(wanted):]:
        place.axis("off")
    for place, (metric, path) in zip(axes.flat, wanted):
        draw(place, results, metric, path)
    figure.suptitle(title)
    return png(figure)

"""Pictures of a batch: each metric by value, with runs as points, and mean with its confidence interval."""

from typing import List, Tuple

import numpy
from matplotlib.axes import Axes

from .input_file import shown
from .pictures import png, pyplot
from .results_table import Results
from .statistics import groups, interval, panels

MOST_POINTS = 500      # shown per value; the violin includes all
MOST_VALUES = 50       # shown per path; the table has all
MOST_PANELS = 100      # per picture
MOST_LETTERS = 30      # of a value below the axis
LARGEST = 1e100        # largest drawn magnitude: its square is finite
LEAST = 1e-100         # smallest spread with a density: its square is not 0
PANEL = (5.6, 3.6)     # inches
TITLE = 0.5            # inches above all panels of a picture


def draw(axes: Axes, results: Results, metric: str, path: str) -> None:
    found = [(value, values[numpy.abs(values) < LARGEST]) for value, values in groups(results, path, metric)]
    found = [(value, values) for value, values in found if len(values)]
    for place, (_, values) in enumerate(found[:MOST_VALUES]):
        _draw_value(axes, place, values)
    axes.set_xticks(range(len(found[:MOST_VALUES])), [_short(value) for value, _ in found[:MOST_VALUES]],
                    rotation=30 if len(found) > 6 or any(len(value) > 8 for value, _ in found) else 0)
    left = f"\n(first {MOST_VALUES} of {len(found)} values)" if len(found) > MOST_VALUES else ""
    axes.set_xlabel(shown(path) + left)
    axes.set_ylabel(shown(metric))
    axes.grid(axis="y", alpha=0.3)


def _draw_value(axes: Axes, place: int, values: numpy.ndarray) -> None:
    if len(values) > 2 and numpy.ptp(values) > max(LEAST, 1e-9 * numpy.abs(values).max()):
        for body in axes.violinplot([values], [place], widths=0.8, showextrema=False)["bodies"]:
            body.set(facecolor="tab:blue", alpha=0.2)
    points = values[:MOST_POINTS]
    sideways = numpy.random.default_rng(0).uniform(-0.12, 0.12, len(points))  # so that equal values do not overlap
    axes.plot(place + sideways, points, ".", color="tab:blue", alpha=0.4, markersize=3)
    mean, low, high = interval(values)
    if numpy.isfinite(low):
        axes.plot([place, place], [low, high], color="black", linewidth=2)
    axes.plot([place], [mean], "o", color="black", markersize=5)


def _short(value: str) -> str:
    text = shown(value)
    return text if len(text) <= MOST_LETTERS else text[:MOST_LETTERS - 3] + "..."


def picture(results: Results, metric: str, path: str) -> bytes:
    """Picture of one metric by the values of one path, as PNG."""
    figure, axes = pyplot.subplots(figsize=PANEL)
    draw(axes, results, metric, path)
    return png(figure)


def all_pictures(results: Results, title: str) -> bytes:
    """All pictures below a title, as one PNG."""
    wanted: List[Tuple[str, str]] = panels(results)
    if len(wanted) > MOST_PANELS:
        title += f" (first {MOST_PANELS} of {len(wanted)} pictures; an .html has all)"
    wanted = wanted[:MOST_PANELS]
    columns = min(2, max(1, len(wanted)))
    rows = max(1, -(-len(wanted) // columns))
    height = PANEL[1] * rows + TITLE
    figure, axes = pyplot.subplots(rows, columns, figsize=(PANEL[0] * columns, height), squeeze=False)
    for place in axes.flat[len(wanted):]:
        place.axis("off")
    for place, (metric, path) in zip(axes.flat, wanted):
        draw(place, results, metric, path)
    figure.suptitle(title, y=1 - TITLE / 2 / height, va="center", wrap=True).set_in_layout(False)
    return png(figure, top=1 - TITLE / height)

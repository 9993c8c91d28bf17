#!/usr/bin/env python3
"""Turns a recorded bag into a table of poses (CSV), a table of events (CSV) and a picture of the trajectories.

    bag_to_csv.py RUN.bag [--out FOLDER]

Reads the topics /space/world_state and /space/events, however the bag was made. Writes poses.csv, events.csv and
trajectories.png: all of them, or nothing. A column `run` counts the resets in the bag, from 0.
Exit code: 0 written, 2 bad input."""

import argparse
import contextlib
import csv
import functools
import itertools
import math
import os
import pathlib
import re
import sys
import tempfile

import matplotlib
import numpy

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
from swarmanoid.bag_file import BagError, load_bag  # noqa: E402

BAD_INPUT = 2
RESULTS = ("poses.csv", "events.csv", "trajectories.png")
MOST_NAMES = 20  # in the legend: the number of distinguishable colours
COLUMNS = 3  # of panels, one a run


class OutError(Exception):
    """Results that cannot be written."""


@functools.lru_cache(maxsize=None)
def natural(name):
    """Sorts fb_2 before fb_10."""
    parts = re.split("([0-9]+)", name)
    return [int(part) if i % 2 else part for i, part in enumerate(parts)], name


def yaw(x, y, z, w):
    return math.atan2(2.0 * (w * z + x * y), 1.0 - 2.0 * (y * y + z * z))


def write_poses(recording, file):
    table = csv.writer(file)
    table.writerow(["run", "tick", "time_s", "name", "type", "x_m", "y_m", "z_m", "yaw_rad", "engine", "gripped"])
    names, types = recording.names, recording.types
    sort = functools.lru_cache(maxsize=None)(lambda columns: sorted(columns, key=lambda column: natural(names[column])))
    for row, (run, tick, time) in enumerate(zip(recording.runs.tolist(), recording.ticks.tolist(), recording.times.tolist())):
        poses, engines, gripped = recording.poses[row].tolist(), recording.engines[row], recording.gripped[row]
        for i in sort(tuple(recording.orders[row].tolist())):
            x, y, z, *orientation = poses[i]
            table.writerow([run, tick, time, names[i], types[i], x, y, z, yaw(*orientation), engines[i], gripped[i]])


def write_events(recording, file):
    table = csv.writer(file)
    table.writerow(["run", "tick", "time_s", "kind", "entity", "other", "text"])
    table.writerows(recording.events)


def count_gaps(recording):
    """Counts the places where ticks are missing within a run."""
    follows = recording.runs[1:] == recording.runs[:-1]
    return int(numpy.count_nonzero(follows & (recording.ticks[1:] > recording.ticks[:-1] + 1)))


def paths_of(recording):
    """Returns the paths of all movable entities, [run][name] = [(x, y), ...] in m, and the colours of preys."""
    runs = max([event.run for event in recording.events] + recording.runs.tolist()) + 1
    paths, colors = [{} for _ in range(runs)], {}
    for row, run in enumerate(recording.runs.tolist()):
        places = recording.poses[row, :, :2].tolist()
        for i in recording.orders[row].tolist():
            if recording.types[i] not in ("block", "light"):
                paths[run].setdefault(recording.names[i], []).append(tuple(places[i]))
                if "prey" in recording.types[i]:
                    colors[recording.names[i]] = tuple(recording.colors[row, i, :3].tolist())
    return paths, colors


def draw(paths_of_runs, prey_colors, title):
    """Draws a panel for each run, all on the same scale, and one legend beside them. Returns the figure."""
    names = sorted({name for paths in paths_of_runs for name in paths}, key=natural)
    palette = plt.get_cmap("tab10" if len(names) <= 10 else "tab20")  # every second colour of tab20 is pale
    colors = {name: prey_colors.get(name, palette(i % palette.N)) for i, name in enumerate(names)}
    columns = min(len(paths_of_runs), COLUMNS)
    rows = math.ceil(len(paths_of_runs) / columns)
    figure, panels = plt.subplots(rows, columns, figsize=(7 * columns, 7 * rows), sharex=True, sharey=True, squeeze=False)
    lines = {}
    for run, (axes, paths) in enumerate(itertools.zip_longest(panels.flat, paths_of_runs, fillvalue={})):
        axes.set_visible(run < len(paths_of_runs))
        for name, path in paths.items():
            xs, ys = zip(*path)
            (lines[name],) = axes.plot(xs, ys, linewidth=1.2, color=colors[name])
            axes.plot(xs[:1], ys[:1], "o", xs[-1:], ys[-1:], "s", color=colors[name])
        axes.set_aspect("equal")
        axes.set_xlabel("x [m]")
        axes.set_ylabel("y [m]")
        axes.tick_params(labelbottom=True, labelleft=True)
        axes.set_facecolor("0.93")
        axes.set_title(f"{title}{f', run {run}' if len(paths_of_runs) > 1 else ''} (circle: start, square: end)")
    figure.tight_layout()
    if 0 < len(names) <= MOST_NAMES:
        panels[0, -1].legend([lines[name] for name in names], names, loc="upper left", bbox_to_anchor=(1.02, 1.0),
                             borderaxespad=0.0, fontsize="small")
    return figure


@contextlib.contextmanager
def all_or_nothing(out):
    """A folder for new results. They move to `out` together, and only if no error occurs before."""
    missing = [folder for folder in [out, *out.parents] if not folder.exists()]
    try:
        if out.exists() and not out.is_dir():
            raise OutError(f"--out: cannot make the folder '{out}': Not a directory")
        try:
            out.mkdir(parents=True, exist_ok=True)
        except OSError as problem:
            raise OutError(f"--out: cannot make the folder '{out}': {problem.strerror}") from None
        for name in RESULTS:
            if (out / name).is_dir():
                raise OutError(f"--out: cannot write {out / name}: Is a directory")
        try:
            with tempfile.TemporaryDirectory(dir=out, prefix=".bag_to_csv_") as folder:
                yield pathlib.Path(folder)
                for name in RESULTS:
                    os.replace(os.path.join(folder, name), out / name)
        except OSError as problem:
            raise OutError(f"--out: cannot write into '{out}': {problem.strerror}") from None
    except BaseException:
        for folder in missing:
            with contextlib.suppress(OSError):
                folder.rmdir()
        raise


def main():
    parser = argparse.ArgumentParser(prog="bag_to_csv", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("bag", type=pathlib.Path)
    parser.add_argument("--out", type=pathlib.Path, default=pathlib.Path("."), help="folder for the results")
    arguments = parser.parse_args()
    try:
        with all_or_nothing(arguments.out) as folder:
            recording = load_bag(arguments.bag)
            if not len(recording.ticks):
                raise BagError(f"{arguments.bag}: holds no /space/world_state")
            paths, colors = paths_of(recording)
            with open(folder / "poses.csv", "w", newline="") as file:
                write_poses(recording, file)
            with open(folder / "events.csv", "w", newline="") as file:
                write_events(recording, file)
            draw(paths, colors, arguments.bag.stem).savefig(folder / "trajectories.png", dpi=110, bbox_inches="tight")
    except (BagError, OutError) as problem:
        print(f"bag_to_csv: {problem}", file=sys.stderr)
        return BAD_INPUT
    runs = len(paths)
    print(f"{arguments.out}: {', '.join(RESULTS)}; {runs} run{'s' if runs > 1 else ''}, {count_gaps(recording)} gaps in the ticks")
    return 0


if __name__ == "__main__":
    sys.exit(main())

#!/usr/bin/env python3
"""Turns a recorded bag into a table of poses (CSV), the story of the run (events, CSV) and a picture of the trajectories.

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

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))  # a devel space runs this file from another folder
from check_bag import BAD_INPUT, BagError, messages  # noqa: E402

RESULTS = ("poses.csv", "events.csv", "trajectories.png")
MOST_NAMES = 20  # in the legend: as many colours can be told apart
COLUMNS = 3  # of panels, one a run


class OutError(Exception):
    """Results that cannot be written."""


class Story:
    """What the tables do not keep: the paths of everything that moves, [run][name] = [(x, y), ...] in m."""

    def __init__(self):
        self.paths = []
        self.colors = {}  # of preys; robots get one in the picture
        self.states = 0
        self.gaps = 0  # places where ticks are missing
        self._numbers = {}  # the space's number of a run to ours: a bag may begin after a reset
        self._last_tick = {}

    def run_of(self, message):
        number = self._numbers.setdefault(message.run, len(self._numbers))
        if number == len(self.paths):
            self.paths.append({})
        return number

    def add(self, run, state):
        self.states += 1
        last = self._last_tick.get(run)
        self.gaps += last is not None and state.tick > last + 1
        self._last_tick[run] = state.tick
        for name, kind, pose, color in zip(state.names, state.types, state.poses, state.colors):
            if kind not in ("block", "light"):
                self.paths[run].setdefault(name, []).append((pose.position.x, pose.position.y))
                if "prey" in kind:
                    self.colors[name] = (color.r, color.g, color.b)


@functools.lru_cache(maxsize=None)
def natural(name):
    """Sorts fb_2 before fb_10."""
    parts = re.split("([0-9]+)", name)
    return [int(part) if i % 2 else part for i, part in enumerate(parts)], name


def kind_name(event):
    """The name of the event's kind, as the bag's own definition of the message has it; of an unknown one the number."""
    names = {value: name.lower() for name, value in vars(type(event)).items() if name.isupper()}
    return names.get(event.kind, event.kind)


def yaw(q):
    return math.atan2(2.0 * (q.w * q.z + q.x * q.y), 1.0 - 2.0 * (q.y * q.y + q.z * q.z))


def write_tables(bag_file, folder):
    """Writes both tables. Returns the story."""
    story = Story()
    with open(folder / "poses.csv", "w", newline="") as poses, open(folder / "events.csv", "w", newline="") as events:
        pose_table, event_table = csv.writer(poses), csv.writer(events)
        pose_table.writerow(["run", "tick", "time_s", "name", "type", "x_m", "y_m", "z_m", "yaw_rad", "engine", "gripped"])
        event_table.writerow(["run", "tick", "time_s", "kind", "entity", "other", "text"])
        for topic, message in messages(bag_file, ["/space/world_state", "/space/events"]):
            run, time = story.run_of(message), message.header.stamp.to_sec()
            if topic == "/space/events":
                event_table.writerow(
                    [run, message.tick, time, kind_name(message), message.entity, message.other, message.text])
                continue
            story.add(run, message)
            for i in sorted(range(len(message.names)), key=lambda i: natural(message.names[i])):
                p = message.poses[i].position
                pose_table.writerow([run, message.tick, time, message.names[i], message.types[i], p.x, p.y, p.z,
                                     yaw(message.poses[i].orientation), message.engines[i], message.gripped[i]])
    return story


def draw(story, title):
    """A panel for each run, all of the same scale, and one legend beside them. Returns the figure."""
    names = sorted({name for paths in story.paths for name in paths}, key=natural)
    palette = plt.get_cmap("tab10" if len(names) <= 10 else "tab20")  # each second one of tab20 is pale
    colors = {name: story.colors.get(name, palette(i % palette.N)) for i, name in enumerate(names)}
    columns = min(len(story.paths), COLUMNS)
    rows = math.ceil(len(story.paths) / columns)
    figure, panels = plt.subplots(rows, columns, figsize=(7 * columns, 7 * rows), sharex=True, sharey=True, squeeze=False)
    lines = {}
    for run, (axes, paths) in enumerate(itertools.zip_longest(panels.flat, story.paths, fillvalue={})):
        axes.set_visible(run < len(story.paths))
        for name, path in paths.items():
            xs, ys = zip(*path)
            (lines[name],) = axes.plot(xs, ys, linewidth=1.2, color=colors[name])
            axes.plot(xs[:1], ys[:1], "o", xs[-1:], ys[-1:], "s", color=colors[name])
        axes.set_aspect("equal")
        axes.set_xlabel("x [m]")
        axes.set_ylabel("y [m]")
        axes.tick_params(labelbottom=True, labelleft=True)
        axes.set_facecolor("0.93")
        axes.set_title(f"{title}{f', run {run}' if len(story.paths) > 1 else ''} (circle: start, square: end)")
    figure.tight_layout()
    if 0 < len(names) <= MOST_NAMES:
        panels[0, -1].legend([lines[name] for name in names], names, loc="upper left", bbox_to_anchor=(1.02, 1.0),
                             borderaxespad=0.0, fontsize="small")
    return figure


@contextlib.contextmanager
def all_or_nothing(out):
    """A folder for new results. They take their places in `out` together, and only if nothing fails until then."""
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
            story = write_tables(arguments.bag, folder)
            if story.states == 0:
                raise BagError(f"{arguments.bag}: holds no /space/world_state")
            draw(story, arguments.bag.stem).savefig(folder / "trajectories.png", dpi=110, bbox_inches="tight")
    except (BagError, OutError) as problem:
        print(f"bag_to_csv: {problem}", file=sys.stderr)
        return BAD_INPUT
    runs = len(story.paths)
    print(f"{arguments.out}: {', '.join(RESULTS)}; {runs} run{'s' if runs > 1 else ''}, {story.gaps} gaps in the ticks")
    return 0


if __name__ == "__main__":
    sys.exit(main())

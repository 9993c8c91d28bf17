"""Figures of batches and evolutions."""

import csv
import json
import pathlib
import subprocess
import tempfile
import time
from typing import NamedTuple

from swarmanoid_studies import run_maker
from swarmanoid_studies.runs import RunRequest

from table import ROOT

EXPERIMENT = "object_retrieval"
FIXED_S = 5e-3  # fixed cost of a run in a batch [s]
FOLDER = ROOT / "src/swarmanoid_studies/studies"
UNSEEN = "101..200"  # seeds not used in evolutions
LIMIT_S = 600
PART = 0.9           # required fraction of the result of handwritten parameters


class Study(NamedTuple):
    name: str
    what: str
    metric: str      # less is better
    measure: str     # meaning of the metric, in words
    unit: str
    by_hand: tuple   # arguments of `swarmanoid batch` for the handwritten solution


STUDIES = (
    Study("phototaxis", "two parameters of phototaxis", "lamps.distance_before_switch", "distance to the lamp", "m",
          ("phototaxis", "--set", "framework.maxclock=1601")),
    Study("neural_phototaxis", "a neural network for phototaxis around obstacles", "lamps.distance_before_switch",
          "distance to the lamp", "m", ("neural_phototaxis", "--set", "arena.fb.controller=pc")),
    Study("neural_aggregation", "a recurrent neural network for aggregation", "dispersion.second_moment",
          "second moment of the swarm", "", ("aggregation", "--set", "framework.maxclock=1000")),
    Study("object_retrieval", "five parameters of object retrieval", "retrieval_ticks", "time until a prey is in the nest", "ticks",
          ("object_retrieval", "--set", "framework.maxclock=3000")),
)


def call(folder, *arguments):
    """@return the summary of a command of `swarmanoid`"""
    done = subprocess.run(["swarmanoid", *map(str, arguments), "--quiet"], cwd=folder, capture_output=True, text=True)
    if done.returncode != 0:
        raise RuntimeError(f"{arguments}: exit {done.returncode}: {done.stderr}")
    return json.loads(done.stdout)


def mean_of(path, metric, **only):
    """Mean of a column of a CSV file. @param only required values of other columns"""
    with open(path, newline="") as file:
        found = [float(row[metric]) for row in csv.DictReader(file) if all(row[name] == value for name, value in only.items())]
    return sum(found) / len(found)


def unseen(folder, name, metric, *arguments):
    """Mean of a metric over the unseen seeds."""
    call(folder, "batch", *arguments, "--seeds", UNSEEN, "--no-report", "--out", f"{name}.csv")
    return mean_of(pathlib.Path(folder) / f"{name}.csv", metric)


def evolution(table, study):
    with tempfile.TemporaryDirectory() as folder:
        by_hand = unseen(folder, "by_hand", study.metric, *study.by_hand)
        starts, ends, walls = [], [], []
        for seed in (1, 2, 3):
            path = FOLDER / f"{study.name}.xml"
            text = path.read_text()
            if "<random_seed>1</random_seed>" not in text:
                raise RuntimeError(f"{path}: found no random seed of 1")
            own = pathlib.Path(folder) / f"study_{seed}.xml"
            own.write_text(text.replace("<random_seed>1</random_seed>", f"<random_seed>{seed}</random_seed>"))
            walls.append(call(folder, "evolve", own, "--out", f"evolved_{seed}")["wall_s"])
            starts.append(mean_of(pathlib.Path(folder) / f"evolved_{seed}/generations.csv", study.metric, generation="1"))
            ends.append(unseen(folder, f"best_{seed}", study.metric, f"evolved_{seed}/best.xml"))
    good = sum(by_hand >= PART * end and wall < LIMIT_S for end, wall in zip(ends, walls))
    start, end = (", ".join(f"{value:.4g}" for value in values) for values in (starts, ends))
    unit = study.unit and f" {study.unit}"
    table.add(f"{study.what} evolved with each of three random seeds, then run with 100 unseen seeds: {study.measure}",
              f"{PART * 100:.0f} % of what is written by hand, in under {LIMIT_S // 60} minutes; 3 of 3",
              f"{end}{unit}, first generations {start}{unit}; by hand {by_hand:.4g}{unit}; in "
              f"{', '.join(f'{wall:.0f}' for wall in walls)} s; {good} of 3", good == 3)


def batch(table):
    """Speed of batches with one and two jobs, interleaved, so that noise of the machine affects both."""
    rates = {1: [], 2: []}
    with tempfile.TemporaryDirectory() as folder:
        for _ in range(3):
            for jobs, found in rates.items():
                found.append(call(folder, "batch", EXPERIMENT, "--seeds", "1..1000", "--jobs", jobs, "--no-report",
                                  "--out", "runs.csv", "--force")["runs_per_s"])
    one, two = (sorted(found)[1] for found in rates.values())
    table.add(f"batch of 1,000 runs of {EXPERIMENT}, two processes against one, median of three", "at least 1.8 times",
              f"{two / one:.2f} times ({one:.1f} and {two:.1f} runs/s)", two >= 1.8 * one)


def fixed_cost(table):
    """Fixed cost of a run in a batch, in one worker process, and the efficiency of a batch on one processor."""
    first, ticks, seconds = [], 0, 0.0
    for seed in range(1, 201):
        begin = time.perf_counter()
        simulation = run_maker.begin(RunRequest(EXPERIMENT, (), seed))
        simulation.tick(1)
        first.append(time.perf_counter() - begin)
        begin = time.perf_counter()
        ticks += simulation.run()["ticks"] - 1
        seconds += time.perf_counter() - begin
    cost = sorted(first)[len(first) // 2]
    table.add(f"fixed cost of a run of {EXPERIMENT} in a batch, to the end of its first tick, median of {len(first)} seeds", "under 5 ms",
              f"{1e3 * cost:.2f} ms; the first one, which reads the file, {1e3 * first[0]:.1f} ms", cost < FIXED_S)
    with tempfile.TemporaryDirectory() as folder:
        summary = call(folder, "batch", EXPERIMENT, "--seeds", f"1..{len(first)}", "--jobs", 1, "--no-report", "--out", "runs.csv")
    possible = 1.0 / (FIXED_S + seconds / len(first))
    share = summary["runs_per_s"] / possible
    table.add(f"batch of {len(first)} runs of {EXPERIMENT}, one process: share of the runs that its ticks/s and 5 ms a run allow", "at least 0.85",
              f"{share:.2f} ({summary['runs_per_s']:.1f} of {possible:.1f} runs/s; {ticks / seconds:,.0f} ticks/s)", share >= 0.85)

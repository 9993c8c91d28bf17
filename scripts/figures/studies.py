"""Figures of batches and evolutions."""

import csv
import json
import pathlib
import subprocess
import tempfile
import time

from swarmanoid_studies import run_maker
from swarmanoid_studies.runs import RunRequest

from table import ROOT

STUDY = ROOT / "src/swarmanoid_studies/studies/phototaxis.xml"
EXPERIMENT = "object_retrieval"
FIXED_S = 5e-3  # of a run in a batch
METRIC = "lamps.distance_before_switch"
UNSEEN = "101..200"  # seeds with which nothing was evolved


def call(folder, *arguments):
    """@return the summary of a command of `swarmanoid`"""
    done = subprocess.run(["swarmanoid", *map(str, arguments), "--quiet"], cwd=folder, capture_output=True, text=True)
    if done.returncode != 0:
        raise RuntimeError(f"{arguments}: exit {done.returncode}: {done.stderr}")
    return json.loads(done.stdout)


def distance(folder, name, experiment, *options):
    """Mean over the unseen seeds [m]."""
    call(folder, "batch", experiment, "--seeds", UNSEEN, "--no-report", "--out", f"{name}.csv", *options)
    with open(pathlib.Path(folder) / f"{name}.csv", newline="") as file:
        found = [float(row[METRIC]) for row in csv.DictReader(file)]
    return sum(found) / len(found)


def evolution(table):
    with tempfile.TemporaryDirectory() as folder:
        by_hand = distance(folder, "by_hand", "phototaxis", "--set", "framework.maxclock=1601")
        evolved, walls = [], []
        for seed in (1, 2, 3):
            study = pathlib.Path(folder) / f"study_{seed}.xml"
            text = STUDY.read_text()
            if "<random_seed>1</random_seed>" not in text:
                raise RuntimeError(f"{STUDY}: found no random seed of 1")
            study.write_text(text.replace("<random_seed>1</random_seed>", f"<random_seed>{seed}</random_seed>"))
            walls.append(call(folder, "evolve", study, "--out", f"evolved_{seed}")["wall_s"])
            evolved.append(distance(folder, f"best_{seed}", f"evolved_{seed}/best.xml"))
    good = sum(by_hand >= 0.9 * each and wall < 600 for each, wall in zip(evolved, walls))
    table.add("two parameters of phototaxis evolved with each of three random seeds, then run with 100 unseen seeds: distance to the lamp",
              "90 % of what is written by hand, in under 10 minutes; 3 of 3",
              f"{', '.join(f'{each:.3f}' for each in evolved)} m; by hand {by_hand:.3f} m; in "
              f"{', '.join(f'{wall:.0f}' for wall in walls)} s; {good} of 3", good == 3)


def batch(table):
    """In turn, so that noise of the machine meets both."""
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
    """Of a run in a batch, in one process of a worker; and what a batch makes of one processor."""
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

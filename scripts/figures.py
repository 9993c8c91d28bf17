#!/usr/bin/env python3
"""Makes the figures that the project promises, and writes them as a table. What is not reached stands there as not reached.

Times are of the machine that ran it; the table says which."""

import argparse
import datetime
import json
import os
import pathlib
import platform
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
MOST_TICKS = 6000


class Table:
    def __init__(self):
        self.rows = []

    def add(self, what, figure, seen, reached):
        self.rows.append((what, figure, seen, "yes" if reached else "**not reached**"))
        print(f"{what}: {seen} ({'reached' if reached else 'NOT REACHED'})", file=sys.stderr)

    def text(self):
        lines = ["| what | promised | seen | reached |", "|---|---|---|---|"]
        return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in self.rows]) + "\n"


def run(*arguments, check=True):
    """Runs an experiment; returns its summary."""
    done = subprocess.run(["swarmanoid", "run", *map(str, arguments), "--quiet"], capture_output=True, text=True)
    if check and done.returncode != 0:
        raise RuntimeError(f"{arguments}: exit {done.returncode}: {done.stderr}")
    return json.loads(done.stdout)


def retrieval(table):
    runs = []
    for seed in range(1, 101):
        print(f"\rseed {seed} of 100", end="", file=sys.stderr, flush=True)
        runs.append(run("object_retrieval", "--seed", seed))
    print(file=sys.stderr)
    good = [r for r in runs if r["success"] and r["ticks"] <= MOST_TICKS]
    colors = [r["metrics"]["chosen_color"] for r in runs]
    each = {color: colors.count(color) for color in sorted(set(colors))}
    table.add("object retrieval, seeds 1-100", f"prey in the nest within {MOST_TICKS} ticks in at least 97",
              f"{len(good)}, median {sorted(r['ticks'] for r in good)[len(good) // 2]} ticks", len(good) >= 97)
    table.add("prey chosen", "each in at least 30", ", ".join(f"{k} {v}" for k, v in each.items()),
              len(each) == 2 and min(each.values()) >= 30)
    speed = sum(r["ticks"] for r in runs) / sum(r["wall_s"] for r in runs)
    table.add("object retrieval, headless", "at least 20,000 ticks/s", f"{speed:,.0f} ticks/s", speed >= 20000)
    return speed


def same_bits(table):
    with tempfile.TemporaryDirectory() as folder:
        def hashes(name, *arguments):
            file = pathlib.Path(folder) / name
            run("object_retrieval", "--seed", 11, "--hashes", file, *arguments)
            return file.read_text()

        first = hashes("a")
        variants = {
            "again": hashes("b"),
            "2 threads": hashes("c", "--threads", 2),
            "bag": hashes("e", "--bag", pathlib.Path(folder) / "run.bag"),
        }
    ticks = len(first.splitlines())
    same = [name for name, text in variants.items() if text == first]
    table.add("same seed: again, on 2 threads, recording a bag", "equal state hash each tick",
              f"equal over {ticks} states: {', '.join(same)}", len(same) == len(variants))


def benchmark(table, build):
    binary = build / "devel/lib/swarmanoid_experiments/swarmanoid_experiments_simulation_benchmark"
    done = subprocess.run([binary, "--benchmark_format=json", "--benchmark_repetitions=3",
                           "--benchmark_report_aggregates_only=true"], capture_output=True, text=True, check=True)
    wanted = {"BM_DiffusionSparse/10": 1e6, "BM_DiffusionSparse/1000": 2e6, "BM_DiffusionSparse/10000": 2e6,
              "BM_DiffusionDense/1000": 5e5, "BM_DiffusionDense/10000": 5e5}
    names = {"Sparse": "one footbot per 1.6 m2", "Dense": "one footbot per 0.1 m2"}
    for entry in json.loads(done.stdout)["benchmarks"]:
        if entry["aggregate_name"] != "median":
            continue
        kind, robots = entry["run_name"].replace("BM_Diffusion", "").split("/")
        least = wanted[entry["run_name"]]
        speed = entry["items_per_second"]
        table.add(f"diffusion, {names[kind]}, {int(robots):,} footbots, one thread",
                  f"at least {least / 1e6:g} million robots x ticks/s", f"{speed / 1e6:.2f} million", speed >= least)


def queries(table, build):
    binary = build / "devel/lib/swarmanoid_space/swarmanoid_space_positional_index_benchmark"
    done = subprocess.run([binary, "--benchmark_format=json"], capture_output=True, text=True, check=True)
    times = {entry["name"]: entry["real_time"] for entry in json.loads(done.stdout)["benchmarks"]}
    for kind in ("2D", "3D"):
        series = [times[f"BM_Query{kind}/{n}"] for n in (100, 1000, 10000, 100000)]
        growth = series[-1] / series[0]
        # log(10^5) / log(10^2) is 2.5
        table.add(f"range query, optimization={kind}, 10^2 to 10^5 entities", "grows as log n or better (at most 2.5 fold)",
                  ", ".join(f"{t:.0f} ns" for t in series) + f"; {growth:.1f} fold", growth <= 2.5)


def long_tests(table, build):
    environment = dict(os.environ, SWARMANOID_LONG_TESTS="1")
    binary = build / "devel/lib/swarmanoid_experiments"
    for name, test, what, figure in (
            ("motion", "Subclocks/*", "0.1 m/s for 10 s and an arc, subclock 1, 2, 5, 10, 50",
             "1.000 m within 1e-9; arc within 0.1 %"),
            ("crowd", "*", "1,000 footbots packed at 0.6 of the area, to one point, then into a wall",
             "no overlap, ever; equal hash on repeat"),
            ("repeatability", "LifeCycle*:Failure*", "every second of 1,000 robots deleted, others spawned; failing controllers",
             "references kept, equal hash on repeat; the robot stops, the others go on")):
        file = binary / f"swarmanoid_experiments_{name}_test"
        done = subprocess.run([file, f"--gtest_filter={test}"], capture_output=True, text=True, env=environment)
        last = [line for line in done.stdout.splitlines() if "PASSED" in line or "FAILED" in line]
        table.add(what, figure, last[0].strip("[ ]").replace("]", ":") if last else "did not run", done.returncode == 0)


def start_up(table):
    with tempfile.TemporaryDirectory() as folder:
        text = (ROOT / "src/swarmanoid_experiments/experiments/diffusion.xml").read_text()
        for old, new in (("12.65,12.65,1", "126.5,126.5,1"), ('quantity="100"', 'quantity="10000"'),
                         ("12.45, 12.45", "126.3, 126.3")):
            text = text.replace(old, new)
        file = pathlib.Path(folder) / "many.xml"
        file.write_text(text)
        start = datetime.datetime.now()
        summary = run(file, "--ticks", 1)
        seconds = (datetime.datetime.now() - start).total_seconds() - summary["wall_s"]
        table.add("10,000 footbots", "start in under 2 s", f"{seconds:.2f} s", seconds < 2.0)


def machine():
    with open("/proc/cpuinfo") as file:
        models = [line.split(":")[1].strip() for line in file if line.startswith("model name")]
    return f"{len(models)} cores of {models[0] if models else platform.machine()}"


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--build", type=pathlib.Path, required=True)
    parser.add_argument("--out", type=pathlib.Path, required=True)
    arguments = parser.parse_args()
    table = Table()
    retrieval(table)
    same_bits(table)
    benchmark(table, arguments.build)
    queries(table, arguments.build)
    long_tests(table, arguments.build)
    start_up(table)
    commit = subprocess.run(["git", "rev-parse", "--short", "HEAD"], capture_output=True, text=True, cwd=ROOT).stdout
    arguments.out.write_text(
        "# Figures\n\nWritten by `./test --long`; times are of one run on "
        f"{machine()}, built from {commit.strip()}, {datetime.date.today()}.\n\n{table.text()}")


if __name__ == "__main__":
    main()

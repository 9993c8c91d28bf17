#!/usr/bin/python3
"""instruction_counts.py BUILD: instructions per tick of five fixed runs, counted by callgrind and compared with stored counts.

Instructions for building the experiment are subtracted. Counts depend on the compiler and the libraries, but hardly on the machine
and not on its load, so they show regressions of a few per cent that times hide. instruction_counts.csv has the counts of a release
build on Debian 12; --write replaces them, which belongs into the commit that changes them, with the reason. The exit code is 1 if a
count is above the limit."""

import argparse
import csv
import pathlib
import re
import subprocess
import sys
import tempfile

from surroundings import outside_of_workspaces

ROOT = pathlib.Path(__file__).resolve().parents[1]
EXPERIMENTS = ROOT / "src/swarmanoid_experiments/experiments"
KEPT = pathlib.Path(__file__).with_suffix(".csv")
LIMIT = 1.02
DIFFUSION = "--set arena.distribute.quantity={n} --set arena.size={s},{s},1 --set arena.distribute.maximum={e},{e},0"
# name, experiment, engine that replaces kinematics2d, arguments, counted ticks
COUNTED = (("diffusion, 10 footbots, kinematics2d", "diffusion", "kinematics2d", DIFFUSION.format(n=10, s=4, e=3.8), 4000),
           ("diffusion, 1,000 footbots, kinematics2d", "diffusion", "kinematics2d", DIFFUSION.format(n=1000, s=40, e=39.8), 200),
           ("diffusion, 100 footbots, dynamics2d", "diffusion", "dynamics2d", "", 200),
           ("diffusion, 10 footbots, dynamics3d", "diffusion", "dynamics3d", DIFFUSION.format(n=10, s=4, e=3.8), 50),
           ("object retrieval", "object_retrieval", "kinematics2d", "", 400))


class Build:
    """A build of the suite; its devel space is sourced for each command."""

    def __init__(self, folder):
        self._setup = pathlib.Path(folder).resolve() / "devel/setup.bash"
        if not self._setup.exists():
            sys.exit(f"found no {self._setup}, allowed: a folder in which the suite was built")

    def call(self, *command, more=None):
        return subprocess.run(["bash", "-c", f'source "{self._setup}" && exec "$@"', "bash", *map(str, command)],
                              env=dict(outside_of_workspaces(), **(more or {})), capture_output=True, text=True, check=False)


def _count(build, file, arguments, ticks):
    done = build.call("valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null", "--trace-children=yes", "swarmanoid", "run",
                      file, "--quiet", "--ticks", ticks, *arguments.split())
    counts = re.findall(r"Collected : (\d+)", done.stderr)
    if done.returncode != 0 or not counts:
        sys.exit(f"{file}: exit code {done.returncode}: {done.stderr[-500:]}")
    return max(map(int, counts))


def counts(*builds):
    """@return for each run, its name and the instructions per tick with each build"""
    with tempfile.TemporaryDirectory(prefix="swarmanoid_counts_") as folder:
        for name, experiment, engine, arguments, ticks in COUNTED:
            file = pathlib.Path(folder) / f"{experiment}_{engine}.xml"
            file.write_text((EXPERIMENTS / f"{experiment}.xml").read_text().replace("kinematics2d id=\"ground\"", f"{engine} id=\"ground\""))
            yield name, [(_count(build, file, arguments, ticks) - _count(build, file, arguments, 1)) / (ticks - 1) for build in builds]


def kept():
    """@return stored instructions per tick by run; empty if none are stored"""
    if not KEPT.exists():
        return {}
    with open(KEPT, newline="") as file:
        return {row["run"]: float(row["instructions_per_tick"]) for row in csv.DictReader(file)}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", help="a build folder")
    parser.add_argument("--write", action="store_true", help="keeps these")
    arguments = parser.parse_args()
    found = {}
    for name, (count,) in counts(Build(arguments.build)):
        found[name] = count
        print(f"{name}: {count:,.0f} instructions a tick", flush=True)
    if arguments.write:
        with open(KEPT, "w", newline="") as file:
            rows = csv.writer(file, lineterminator="\n")
            rows.writerow(("run", "instructions_per_tick"))
            rows.writerows((name, round(count)) for name, count in found.items())
        return 0
    before = kept()
    if not before:
        sys.exit(f"found no {KEPT}, allowed: --write, which keeps these")
    above = [name for name, count in found.items() if count > LIMIT * before[name]]
    for name in above:
        print(f"{name}: found {found[name]:,.0f}, allowed: {LIMIT:g} times {before[name]:,.0f}, which is kept in {KEPT}", file=sys.stderr)
    return 1 if above else 0


if __name__ == "__main__":
    sys.exit(main())

"""The table of figures, and runs of experiments for it."""

import datetime
import json
import pathlib
import platform
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
# Pages and scripts of figures, which are no part of the measured code. A change of a row's script requires a new measurement.
OF_FIGURES = ("docs", "CHANGELOG.md", "scripts/figures", "src/swarmanoid_experiments/fuzz")
HEAD = ["what", "promised", "seen", "reached", "from"]


class Table:
    """Rows by their first column. New rows replace those of the page; the others keep the commit and the day of their
    measurement."""

    def __init__(self, page=""):
        """@param page the earlier page"""
        rows = [line.strip("| ").split(" | ") for line in page.splitlines() if line.startswith("| ")][2:]
        self._rows = {row[0]: row for row in rows}
        # the last commit of the measured code, since rows may be measured and committed over several days
        commit = subprocess.run(["git", "log", "-1", "--format=%h", "--", ".", *(f":(exclude){path}" for path in OF_FIGURES)],
                                capture_output=True, text=True, cwd=ROOT, check=True)
        self._origin = f"{commit.stdout.strip()}, {datetime.date.today()}"

    def add(self, what, figure, seen, reached):
        """@param reached None if the figure is not promised"""
        verdict = "-" if reached is None else "yes" if reached else "**not reached**"
        self._rows[what] = [what, figure, seen, verdict, self._origin]
        print(f"{what}: {seen} ({verdict})", file=sys.stderr)

    def text(self):
        rows = [HEAD, ["---"] * len(HEAD), *self._rows.values()]
        return "".join("| " + " | ".join(row) + " |\n" for row in rows)


def run(*arguments, check=True):
    """Runs an experiment without ROS; returns its summary."""
    done = subprocess.run(["swarmanoid", "run", *map(str, arguments), "--quiet"], capture_output=True, text=True)
    if check and done.returncode != 0:
        raise RuntimeError(f"{arguments}: exit {done.returncode}: {done.stderr}")
    return json.loads(done.stdout)


def machine():
    with open("/proc/cpuinfo") as file:
        models = [line.split(":")[1].strip() for line in file if line.startswith("model name")]
    return f"{len(models)} cores of {models[0] if models else platform.machine()}"

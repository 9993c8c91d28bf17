"""The table of figures, and running experiments for it."""

import json
import pathlib
import platform
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]


class Table:
    def __init__(self):
        self.rows = []

    def add(self, what, figure, seen, reached):
        """reached is None where nothing is promised."""
        verdict = "-" if reached is None else "yes" if reached else "**not reached**"
        self.rows.append((what, figure, seen, verdict))
        print(f"{what}: {seen} ({verdict})", file=sys.stderr)

    def text(self):
        lines = ["| what | promised | seen | reached |", "|---|---|---|---|"]
        return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in self.rows]) + "\n"


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

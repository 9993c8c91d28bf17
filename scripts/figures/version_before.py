"""Speed against a version before, which is built as well and run in turn: ratios say the same on any machine."""

import pathlib
import statistics
import subprocess
import sys
import tempfile

from build_time import processor_time
from simulation import diffusion_of
from table import ROOT

sys.path.insert(0, str(ROOT / "scripts"))
from instruction_counts import Build  # noqa: E402  pylint: disable=wrong-import-position
from surroundings import outside_of_workspaces  # noqa: E402  pylint: disable=wrong-import-position

BEFORE = "89bb5cad"  # of 26 November 2026, the last one before the engines were made faster
PAIRS = 5
FIRST_TICKS = 20  # are taken off, with the start
# robots; ticks; million robots x ticks/s that were measured of such a version when the goal was set, and the goal
GOALS = ((10, 400_000, 2.3, 4), (1_000, 6_000, 4.3, 8), (10_000, 2_000, 4.8, 8), (100_000, 200, 3.0, 6))


def build_before(source):
    """As that version builds itself."""
    done = subprocess.run(["bash", "-c", "set -eu; root=$PWD; source scripts/setup.sh; build build -DBUILD_TESTS_IN_ALL=OFF"],
                          cwd=source, env=outside_of_workspaces(), capture_output=True, text=True)
    if done.returncode != 0:
        raise RuntimeError(f"{BEFORE} was not built: {done.stdout[-2000:]}{done.stderr[-2000:]}")
    return Build(source / "build")


def speed(build, file, robots, ticks):
    """@return million robots x ticks in a second of processor time"""
    seconds = []
    for until in (FIRST_TICKS, FIRST_TICKS + ticks):
        start = processor_time()
        done = build.call("swarmanoid", "run", file, "--quiet", "--threads", 1, "--ticks", until)
        if done.returncode != 0:
            raise RuntimeError(f"{file}: exit code {done.returncode}: {done.stderr}")
        seconds.append(processor_time() - start)
    return 1e-6 * robots * ticks / (seconds[1] - seconds[0])


def version_before(table, build):
    now = Build(build)
    with tempfile.TemporaryDirectory(prefix="swarmanoid_before_") as folder:
        source = pathlib.Path(folder) / "source"
        subprocess.run(["git", "worktree", "add", "--quiet", "--detach", source, BEFORE], cwd=ROOT, check=True)
        try:
            before = build_before(source)
            for robots, ticks, measured, goal in GOALS:
                file = diffusion_of(folder, robots, source)
                pairs = [(speed(before, file, robots, ticks), speed(now, file, robots, ticks)) for _ in range(PAIRS)]
                ratio = statistics.median(after / first for first, after in pairs)
                first, after = (statistics.median(speeds) for speeds in zip(*pairs))
                what = f"diffusion, one footbot per 1.6 m2, {robots:,} footbots, one thread, against {BEFORE} in turn, median of {PAIRS}"
                table.add(what, f"at least {goal / measured:.2f} times: {goal} million where that made {measured:g}",
                          f"{ratio:.2f} times ({first:.2f} and {after:.2f} million robots x ticks/s)", ratio >= goal / measured)
        finally:
            subprocess.run(["git", "worktree", "remove", "--force", source], cwd=ROOT, check=True)

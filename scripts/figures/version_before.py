"""Speed compared with an earlier version, which is also built, and run interleaved: ratios are comparable between machines."""

import pathlib
import statistics
import subprocess
import sys
import tempfile
from typing import NamedTuple

from build_time import processor_time
from simulation import diffusion_of
from table import ROOT

sys.path.insert(0, str(ROOT / "scripts"))
from instruction_counts import Build  # noqa: E402  pylint: disable=wrong-import-position
from surroundings import outside_of_workspaces  # noqa: E402  pylint: disable=wrong-import-position

BEFORE = "9a27db6d"  # of 29 November 2026, the last commit before corrections of pushing and friction in the engines
PAIRS = 3
FIRST_TICKS = 20  # subtracted, with the start of the program
GOAL = 0.9


class World(NamedTuple):
    engine: str
    subclock: int
    robots: int
    ticks: int


WORLDS = (World("kinematics2d", 1, 10, 400_000), World("kinematics2d", 1, 1_000, 6_000), World("kinematics2d", 1, 10_000, 1_000),
          World("dynamics2d", 4, 10, 80_000), World("dynamics2d", 4, 1_000, 800), World("dynamics2d", 4, 10_000, 100),
          World("dynamics3d", 10, 10, 10_000), World("dynamics3d", 10, 100, 1_000), World("dynamics3d", 10, 1_000, 100))


def build_before(source):
    """Builds that version by its own scripts."""
    done = subprocess.run(["bash", "-c", "set -eu; root=$PWD; source scripts/setup.sh; build build -DBUILD_TESTS_IN_ALL=OFF"],
                          cwd=source, env=outside_of_workspaces(), capture_output=True, text=True)
    if done.returncode != 0:
        raise RuntimeError(f"{BEFORE} was not built: {done.stdout[-2000:]}{done.stderr[-2000:]}")
    return Build(source / "build")


def speed(build, file, world):
    """@return thousands of robots x ticks per second of processor time"""
    seconds = []
    for until in (FIRST_TICKS, FIRST_TICKS + world.ticks):
        start = processor_time()
        done = build.call("swarmanoid", "run", file, "--quiet", "--threads", 1, "--ticks", until)
        if done.returncode != 0:
            raise RuntimeError(f"{file}: exit code {done.returncode}: {done.stderr}")
        seconds.append(processor_time() - start)
    return 1e-3 * world.robots * world.ticks / (seconds[1] - seconds[0])


def file_of(folder, world, source):
    """@return file of the experiment diffusion with the world's engine and number of robots"""
    file = diffusion_of(folder, world.robots, source)
    text, old = file.read_text(), '<kinematics2d id="ground"/>'
    if old not in text:
        raise RuntimeError(f"diffusion.xml: found no {old}")
    file.write_text(text.replace(old, f'<{world.engine} id="ground"><subclock>{world.subclock}</subclock></{world.engine}>'))
    return file


def version_before(table, build):
    now = Build(build)
    with tempfile.TemporaryDirectory(prefix="swarmanoid_before_") as folder:
        source = pathlib.Path(folder) / "source"
        subprocess.run(["git", "worktree", "add", "--quiet", "--detach", source, BEFORE], cwd=ROOT, check=True)
        try:
            before = build_before(source)
            for world in WORLDS:
                file = file_of(folder, world, source)
                pairs = [(speed(before, file, world), speed(now, file, world)) for _ in range(PAIRS)]
                ratio = statistics.median(after / first for first, after in pairs)
                first, after = (statistics.median(speeds) for speeds in zip(*pairs))
                table.add(f"diffusion, one footbot per 1.6 m2, {world.engine}, steps a tick {world.subclock}, {world.robots:,} footbots, one "
                          f"thread, against {BEFORE} in turn, median of {PAIRS}", f"at least {GOAL} times where nothing is pushed",
                          f"{ratio:.2f} times ({first:,.0f} and {after:,.0f} thousand robots x ticks/s)", ratio >= GOAL)
        finally:
            subprocess.run(["git", "worktree", "remove", "--force", source], cwd=ROOT, check=True)

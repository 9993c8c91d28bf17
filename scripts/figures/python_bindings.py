"""Figures of the simulator in Python."""

import pathlib
import statistics
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent

AT_ONCE = """
import time, swarmanoid
from python_diffusion import AtOnce, experiment
robots = {robots}
chunk, rounds = max(20, 400_000 // robots), 9
runs = [swarmanoid.Simulation(text=experiment(robots), seed=1, controllers=controllers)
        for controllers in ({{}}, {{"dc": AtOnce()}})]
seconds = [[], []]
for run in runs:
    run.tick(chunk)
for _ in range(rounds):
    for run, spent in zip(runs, seconds):
        start = time.perf_counter()
        run.tick(chunk)
        spent.append(time.perf_counter() - start)
rates = [[robots * chunk / each for each in spent] for spent in seconds]
print(repr((rates, [run.state_hash for run in runs])))
"""

ALONE = """
import time, swarmanoid
from python_diffusion import Alone, experiment
runs = [swarmanoid.Simulation(text=experiment(20), seed=1, controllers=controllers) for controllers in ({}, {"dc": Alone})]
rates = []
for _ in range(5):
    start = time.perf_counter()
    runs[1].tick(5000)
    rates.append(20 * 5000 / (time.perf_counter() - start))
    runs[0].tick(5000)
print(repr((rates, [run.state_hash for run in runs])))
"""

MEMORY = """
import os, swarmanoid
from python_diffusion import Alone, AtOnce, experiment
text = experiment(20)

class Count:
    def after_tick(self, world):
        self.robots = len(world.robots)

def resident():
    with open("/proc/self/statm") as file:
        return int(file.read().split()[1]) * os.sysconf("SC_PAGESIZE") // 1024

def make(count):
    for i in range(count):
        controller = (None, AtOnce(), Alone)[i % 3]
        controllers = {"dc": controller} if controller else {}
        swarmanoid.Simulation(text=text, seed=i, controllers=controllers, rules={"count": Count()}).tick(2)

make(1000)   # permanent objects exist by then
before = resident()
make(10000)
print(repr(resident() - before))
"""


def evaluate(program):
    """Runs a program in a separate process. @return the value that it prints"""
    done = subprocess.run([sys.executable, "-c", program], cwd=HERE, capture_output=True, text=True)
    if done.returncode != 0:
        raise RuntimeError(done.stderr)
    return eval(done.stdout)


def python_at_once(table):
    for robots, least in ((10000, 0.5), (1000, 0.4)):
        (cpp, python), hashes = evaluate(AT_ONCE.format(robots=robots))
        ratio = statistics.median(mine / theirs for mine, theirs in zip(python, cpp))
        same = hashes[0] == hashes[1]
        table.add(f"diffusion in Python over all robots at once against C++, {robots:,} footbots, in turn, median of {len(cpp)} pairs",
                  f"the same bits, at least {least:g} of the speed",
                  f"{'equal' if same else 'different'} state hash; {ratio:.2f} of the speed "
                  f"({statistics.median(python) / 1e6:.2f} and {statistics.median(cpp) / 1e6:.2f} million robots x ticks/s)",
                  same and ratio >= least)


def python_alone(table):
    rates, hashes = evaluate(ALONE)
    rate = statistics.median(rates)
    same = hashes[0] == hashes[1]
    table.add("diffusion in Python one robot at a time, 20 footbots, median of 5", "the same bits, at least 100,000 robots x ticks/s",
              f"{'equal' if same else 'different'} state hash; {rate:,.0f} robots x ticks/s", same and rate >= 1e5)


def python_memory(table):
    most = 1024   # [KiB], for pages kept by the allocator
    growth = evaluate(MEMORY)
    table.add("10,000 simulations with controllers and a rule in Python, made and dropped in one process: growth of its memory after the "
              "first 1,000", f"none: under {most:,} KiB", f"{growth:,} KiB", growth < most)

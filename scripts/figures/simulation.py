"""Figures of whole runs without ROS."""

import json
import os
import pathlib
import subprocess
import sys
import tempfile
import time

from robots import last_words_of
from table import ROOT, run

MOST_TICKS = 6000


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
    table.add("object retrieval, headless", "at least 80,000 ticks/s", f"{speed:,.0f} ticks/s", speed >= 80000)
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


def threads(table):
    """Speed with threads, with many more robots than in the experiments, so that all threads get work."""
    ticks = 300
    with tempfile.TemporaryDirectory() as folder:
        for robots in (10000, 100000):
            file = diffusion_of(folder, robots)
            found = []
            for count in (1, 2, 4, 8):
                hashes = pathlib.Path(folder) / f"{robots}_{count}.txt"
                run(file, "--ticks", ticks, "--threads", count, "--hashes", hashes)
                found.append(hashes.read_text())
            same = sum(text == found[0] for text in found)
            table.add(f"diffusion, {robots:,} footbots, on 1, 2, 4, 8 threads", "equal state hash each tick",
                      f"equal over {len(found[0].splitlines())} states: {same} of {len(found)}", same == len(found))


def any_processor(table):
    """The long version of a test: all installed experiments, with and without fused multiply-add."""
    test = ROOT / "src/swarmanoid_experiments/test/program_same_bits_test.py"
    table.add("all installed experiments, seeds 1-10, 1,000 ticks, fused multiply-add of the processor seen or hidden",
              "equal state hash", *last_words_of([test], SWARMANOID_LONG_TESTS="1"))


def diffusion_of(folder, robots, source=ROOT):
    """The experiment `diffusion` of a source tree with another number of robots, and the same floor area per robot.
    @return its file"""
    text = (source / "src/swarmanoid_experiments/experiments/diffusion.xml").read_text()
    side = 1.265 * robots ** 0.5
    for old, new in (("12.65,12.65,1", f"{side:.4f},{side:.4f},1"), ('quantity="100"', f'quantity="{robots}"'),
                     ("12.45, 12.45", f"{side - 0.2:.4f}, {side - 0.2:.4f}")):
        if old not in text:
            raise RuntimeError(f"diffusion.xml: found no {old}")
        text = text.replace(old, new)
    file = pathlib.Path(folder) / f"diffusion_{robots}.xml"
    file.write_text(text)
    return file


def first_tick(folder, robots):
    """@return seconds from the command to the end of the first tick, peak memory of the process [KiB]"""
    start = time.perf_counter()
    program = subprocess.Popen(["swarmanoid", "run", diffusion_of(folder, robots), "--ticks", "1", "--quiet"],
                               stdout=subprocess.PIPE, text=True)
    summary = json.loads(program.stdout.readline())  # afterwards the process only exits
    seconds = time.perf_counter() - start
    _, status, usage = os.wait4(program.pid, 0)
    found = round(summary["robot_ticks_per_s"] * summary["wall_s"])
    if status != 0 or found != robots:
        raise RuntimeError(f"{robots} footbots: status {status}, {found} robots")
    return seconds, usage.ru_maxrss


def start_up(table):
    with tempfile.TemporaryDirectory() as folder:
        _, base = first_tick(folder, 1)
        for robots in (10000, 100000):
            seconds, memory = first_tick(folder, robots)
            table.add(f"{robots:,} footbots, from the command to the end of the first tick", "start in under 2 s",
                      f"{seconds:.2f} s", seconds < 2.0)
        each = (memory - base) / robots
        table.add(f"{robots:,} footbots: memory of each", "under 2.5 KiB", f"{each:.2f} KiB", each < 2.5)

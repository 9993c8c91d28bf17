"""Figures of the benchmarks."""

import json
import subprocess
import sys

from table import ROOT

sys.path.insert(0, str(ROOT / "scripts"))
import instruction_counts  # noqa: E402  pylint: disable=wrong-import-position


def medians(binary, names=".*", repetitions=5, seconds=0.5):
    """Medians of some benchmarks by name, with interleaved repetitions. They run in a process of their own, since the heap that
    other benchmarks leave has an effect. @param seconds of each repetition"""
    done = subprocess.run([binary, "--benchmark_format=json", f"--benchmark_filter=^BM_({names})$",
                           f"--benchmark_repetitions={repetitions}", f"--benchmark_min_time={seconds}",
                           "--benchmark_enable_random_interleaving=true", "--benchmark_report_aggregates_only=true"],
                          capture_output=True, text=True, check=True)
    return {entry["run_name"].replace("BM_", "", 1): entry for entry in json.loads(done.stdout)["benchmarks"]
            if entry["aggregate_name"] == "median"}


def speeds(binary, *arguments):
    """Items per second of some benchmarks by name, as medians."""
    return {name: entry["items_per_second"] for name, entry in medians(binary, *arguments).items()}


def benchmark(table, build):
    """Diffusion, interleaved with a bare loop, the shortest program with the same result (bare_diffusion.hpp)."""
    binary = build / "devel/lib/swarmanoid_experiments/swarmanoid_experiments_simulation_benchmark"
    goals = {"Sparse/10": 4, "Sparse/1000": 8, "Sparse/10000": 8, "Sparse/100000": 6, "Dense/1000": 1.5, "Dense/10000": 1.5}
    area = {"Sparse": "1.6 m2", "Dense": "0.1 m2"}
    for name, million in goals.items():
        kind, robots = name.split("/")
        speed = speeds(binary, f"(Diffusion|Bare){name}")
        seen, bare = speed[f"Diffusion{name}"], speed[f"Bare{name}"]
        table.add(f"diffusion, one footbot per {area[kind]}, {int(robots):,} footbots, one thread",
                  f"at least {million:g} million robots x ticks/s",
                  f"{seen / 1e6:.2f} million; {seen / bare:.2f} of a bare loop of discs, {bare / 1e6:.1f} million", seen >= 1e6 * million)
    for robots in ("10000", "100000"):
        speed = speeds(binary, f"DiffusionThreads/{robots}/[12]/real_time")
        one, two = (speed[f"DiffusionThreads/{robots}/{threads}/real_time"] for threads in (1, 2))
        table.add(f"diffusion, one footbot per 1.6 m2, {int(robots):,} footbots, two threads against one, all phases",
                  "at least 1.7 times where two whole cores are free",
                  f"{two / one:.2f} times ({one / 1e6:.2f} and {two / 1e6:.2f} million robots x ticks/s)", two >= 1.7 * one)
    speed = speeds(binary, "Maze/.*")
    walls = {held: speed["Maze/0/1"] / speed[f"Maze/1000/{held}"] for held in (0, 1)}
    table.add("1,000 footbots among 1,000 walls of 1.2 m, 128 m x 128 m, against the four walls of the arena alone: length of a tick",
              "at most 1.5 times", f"{walls[0]:.2f} times if sensors alone meet them, {walls[1]:.2f} if robots do, too",
              max(walls.values()) <= 1.5)
    for robots in ("1000", "10000"):
        speed = speeds(binary, f"MessagesSparse/{robots}")
        seen = speed[f"MessagesSparse/{robots}"]
        table.add(f"range and bearing, one footbot per 1.6 m2, all send, {int(robots):,} footbots, one thread",
                  "at least 0.6 million robots x ticks/s", f"{seen / 1e6:.2f} million", seen >= 6e5)


def acting_world(table, build):
    binary = build / "devel/lib/swarmanoid_experiments/swarmanoid_experiments_acting_world_benchmark"
    found = medians(binary)
    share = found["Rule/10000"]["rule_share"]
    table.add("a rule that looks at 10,000 robots after each tick of diffusion", "under 3 % of the tick", f"{100 * share:.2f} %",
              share < 0.03)
    costs = {name.split("/")[1]: entry["rule_us"] for name, entry in found.items() if name.startswith("Measure")}
    dearest = max(costs, key=costs.get)
    table.add("a rule of the suite that measures 10,000 footbots after each tick", "under 2 ms",
              f"from {1e-3 * min(costs.values()):.3f} to {1e-3 * costs[dearest]:.3f} ms ({dearest})", costs[dearest] < 2000.0)
    clean, painted, anew = (found[f"Floor/{i}"]["real_time"] for i in range(3))
    table.add("a painted floor of 1,000 x 1,000 cells that fades, read by 100 footbots: a tick and its hash longer than on a clean floor",
              "under 1 ms", f"{1e-3 * (painted - clean):.3f} ms; {1e-3 * (anew - clean):.3f} ms while 100 discs are painted a tick "
              f"({1e-3 * clean:.3f} ms on a clean floor)", max(painted, anew) - clean < 1000.0)


def sensing(table, build):
    """Speed with sensors. Repetitions are long, since a tick with all devices takes 0.1 s and the first ticks are slower."""
    binary = build / "devel/lib/swarmanoid_experiments/swarmanoid_experiments_sensing_benchmark"
    speed = speeds(binary, ".*", 3, 3)
    everybody = "10,000 footbots that turn on the spot, one per 1.6 m2, one thread"
    for name, what, least in (("Messages", "range and bearing (3 m, all send) alone", 0.6e6),
                              ("Light", "light (10 bulbs 2 m high that reach 5 m) alone", 1e6),
                              ("Ground", "ground sensors alone", 2.5e6)):
        table.add(f"{what}: {everybody}", f"at least {least / 1e6:g} million robots x ticks/s", f"{speed[name] / 1e6:.2f} million",
                  speed[name] >= least)
    alone = {name: 1e6 / speed[name] - 1e6 / speed["Nothing"] for name in speed if name.split("/")[0] not in ("All", "Nothing")}
    shares = ", ".join(f"{name.lower()} {alone[name]:.2f}" for name in ("Proximity", "Light", "Ground", "Scanner", "Messages"))
    table.add("proximity (0.1 m), light (of LEDs to 0.5 m), ground, scanner (1.5 m), range and bearing (3 m), blob camera (1.5 m) "
              f"all on: {everybody}", "at least 0.1 million robots x ticks/s",
              f"{speed['All/50'] / 1e6:.3f} million ({speed['All/100'] / 1e6:.3f} million with light of LEDs to 1 m); "
              f"microseconds a robot and tick: {shares}, camera {alone['Camera/150']:.2f}, "
              f"without devices {1e6 / speed['Nothing']:.2f}", speed["All/50"] >= 1e5)
    curve = ", ".join(f"{int(name.split('/')[1]) / 100:g} m {alone[name]:.1f}" for name in sorted(alone, key=lambda n: (len(n), n))
                      if name.startswith("Camera"))
    table.add(f"blob camera by its range, microseconds a robot and tick: {everybody}, all LEDs lit", "reported", curve, None)


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


def instructions(table, build):
    kept = instruction_counts.kept()
    for name, (count,) in instruction_counts.counts(instruction_counts.Build(build)):
        what, before = f"{name}: instructions a tick (callgrind)", kept.get(name)
        if before is None:
            table.add(what, f"at most {instruction_counts.LIMIT:g} times what is kept", f"{count:,.0f}; nothing is kept yet", False)
        else:
            table.add(what, f"at most {instruction_counts.LIMIT:g} times {before:,.0f}, which is kept",
                      f"{count:,.0f}; {count / before:.3f} times", count <= instruction_counts.LIMIT * before)

#!/usr/bin/python3
"""compare_builds.py BEFORE AFTER: checks that two builds of the suite give equal runs, for changes that must not change results.

BEFORE and AFTER are build folders. All installed experiments and the retrieval in each mapping of engines are run and recorded with
both, with one thread and with two, and compared field by field (`swarmanoid diff`); with --launched also under ROS. Then callgrind
counts the instructions of five runs, without those for building the experiment. The exit code is 0 if all fields are equal and no
count is above the limit."""

import argparse
import itertools
import pathlib
import re
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT / "scripts/figures"))
sys.path.insert(0, str(ROOT / "src/swarmanoid_experiments/rostest"))
import engines  # noqa: E402  pylint: disable=wrong-import-position
from instruction_counts import EXPERIMENTS, LIMIT, Build, counts  # noqa: E402  pylint: disable=wrong-import-position
from roslaunch_process import free_port  # noqa: E402  pylint: disable=wrong-import-position

EQUAL = re.compile(r"equal: .* of all named state, .* of readings and commands")  # a full comparison


def record(build, experiment, seed, threads, bag):
    done = build.call("swarmanoid", "run", experiment, "--quiet", "--seed", seed, "--threads", threads, "--bag", bag, "--force",
                      "--record-state", "--record-controllers", "all")
    return "" if done.returncode == 0 else f"exit code {done.returncode}: {done.stderr.strip()[-300:]}"


def record_launched(build, experiment, seed, bag):
    done = build.call("swarmanoid", "launch", experiment, "rviz:=false", "real_time_factor:=0", f"seed:={seed}", f"record:={bag}",
                      "write_anywhere:=true", "force:=true", "record_state:=true", "record_controllers:=all", "-p", free_port(),
                      more={"ROS_HOSTNAME": "localhost"})
    return "" if done.returncode == 0 else f"exit code {done.returncode}: {done.stdout[-300:]}"


def experiments(folder):
    """All installed experiments, and the retrieval with each engine for footbots and eyebot."""
    yield from sorted(EXPERIMENTS.glob("*.xml"))
    text = (EXPERIMENTS / "object_retrieval.xml").read_text()
    for ground, sky in itertools.product(engines.ENGINES["ground"], engines.ENGINES["sky"]):
        file = pathlib.Path(folder) / f"retrieval_{ground}_{sky}.xml"
        file.write_text(text.replace(engines.GROUND, engines.ENGINES["ground"][ground])
                        .replace(engines.SKY, engines.ENGINES["sky"][sky]))
        yield file


def compare_bits(before, after, arguments):
    """@return number of comparisons with differences"""
    differing = 0
    with tempfile.TemporaryDirectory(prefix="swarmanoid_compare_") as folder:
        first, second = (pathlib.Path(folder) / name for name in ("before.bag", "after.bag"))
        for experiment in experiments(folder):
            if arguments.experiments and experiment.stem not in arguments.experiments:
                continue
            said = []
            for seed in range(1, arguments.seeds + 1):
                threads = 1 + seed % 2
                print(f"\r{experiment.stem}: seed {seed} ", end="", file=sys.stderr, flush=True)
                trouble = record(before, experiment, seed, 1, first) or record(after, experiment, seed, threads, second)
                said.append(trouble or after.call("swarmanoid", "diff", first, second).stdout.strip())
                if seed <= arguments.launched:
                    trouble = record_launched(after, experiment, seed, second)
                    said.append(trouble or after.call("swarmanoid", "diff", first, second).stdout.strip())
            bad = [text for text in said if not EQUAL.fullmatch(text)]
            differing += len(bad)
            print(f"\r{experiment.stem}: {len(said) - len(bad)} of {len(said)} equal; {(bad or said)[0]}", flush=True)
    return differing


def compare_counts(before, after):
    """@return number of counts above the limit"""
    above = 0
    for name, (old, new) in counts(before, after):
        above += new > LIMIT * old
        print(f"{name}: {old:,.0f} instructions a tick before, {new:,.0f} after: {new / old:.4f}", flush=True)
    return above


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("before", help="a build folder")
    parser.add_argument("after", help="likewise")
    parser.add_argument("--seeds", type=int, default=20, help="of each experiment (20)")
    parser.add_argument("--launched", type=int, default=0, help="how many of them also under ROS (0)")
    parser.add_argument("--experiments", nargs="+", metavar="NAME", help="only these are compared field by field")
    parser.add_argument("--only", choices=("bits", "counts"))
    arguments = parser.parse_args()
    before, after = Build(arguments.before), Build(arguments.after)
    wrong = 0
    if arguments.only != "counts":
        wrong += compare_bits(before, after, arguments)
    if arguments.only != "bits":
        wrong += compare_counts(before, after)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())

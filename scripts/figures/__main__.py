#!/usr/bin/env python3
"""Measures the figures that the project promises, and writes them to a table, which also marks figures that are not reached.

Times are valid for the machine that the table names."""

import argparse
import pathlib
import signal

import benchmarks
import build_time
import classic
import cost
import crowds
import devices
import engines
import lockstep
import long_tests
import python_bindings
import robots
import robustness
import simulation
import structure
import studies
import study_processes
import under_ros
import version_before
import worlds
from table import ROOT, Table, machine

FIGURES = {
    "retrieval": lambda table, build: simulation.retrieval(table),
    "same_bits": lambda table, build: simulation.same_bits(table),
    "any_processor": lambda table, build: simulation.any_processor(table),
    "ros_speed": lambda table, build: under_ros.speed(table),
    "ros_recording": lambda table, build: under_ros.recording(table),
    "ros_same_bits": lambda table, build: under_ros.same_bits(table),
    "lockstep": lambda table, build: lockstep.lockstep(table),
    "robots": robots.robots,
    "benchmark": benchmarks.benchmark,
    "costs": lambda table, build: cost.costs(table),
    "version_before": version_before.version_before,
    "acting_world": benchmarks.acting_world,
    "sensing": benchmarks.sensing,
    "queries": benchmarks.queries,
    "instructions": benchmarks.instructions,
    "classic": lambda table, build: classic.classic(table),
    "long_tests": long_tests.long_tests,
    "mappings": lambda table, build: engines.mappings(table),
    "cooperation": lambda table, build: engines.cooperation(table),
    "dynamics2d": engines.dynamics2d,
    "dynamics3d": engines.dynamics3d,
    "crowds": lambda table, build: crowds.crowds(table),
    "mixed": lambda table, build: engines.mixed(table),
    "oracles": engines.oracles,
    "climbing": engines.climbing,
    "threads": lambda table, build: simulation.threads(table),
    "start_up": lambda table, build: simulation.start_up(table),
    "devices": devices.devices,
    "structure": structure.structure,
    "python_at_once": lambda table, build: python_bindings.python_at_once(table),
    "python_alone": lambda table, build: python_bindings.python_alone(table),
    "python_memory": lambda table, build: python_bindings.python_memory(table),
    "worlds": lambda table, build: worlds.worlds(table),
    **{f"evolution_{study.name}": lambda table, build, study=study: studies.evolution(table, study) for study in studies.STUDIES},
    "batch": lambda table, build: studies.batch(table),
    "batch_cost": lambda table, build: studies.fixed_cost(table),
    "study_kills": lambda table, build: study_processes.kills(table),
    "study_workers": lambda table, build: study_processes.workers(table),
    "cluster": lambda table, build: study_processes.cluster(table),
    "fuzzers": robustness.fuzzers,
    "sanitizers": lambda table, build: robustness.sanitizers(table),
    "coverage": lambda table, build: robustness.coverage(table),
    "sanitizer": lambda table, build: long_tests.sanitizer(table),
    "fresh_clone": lambda table, build: build_time.fresh_clone(table),
    "fresh_tests": lambda table, build: build_time.fresh_tests(table),
    "fresh_machines_run": lambda table, build: build_time.fresh_machines(table, "./run", "--headless"),
    "fresh_machines_test": lambda table, build: build_time.fresh_machines(table, "./test"),
}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=pathlib.Path, required=True, help="build folder, whose devel space is sourced")
    parser.add_argument("--out", type=pathlib.Path, required=True, help="the page; rows that are not made anew stay")
    parser.add_argument("--only", nargs="+", choices=FIGURES, default=list(FIGURES), help="some of them")
    arguments = parser.parse_args()
    # a program started in the background ignores SIGINT, with which tests end their child processes
    signal.signal(signal.SIGINT, signal.default_int_handler)
    table = Table(arguments.out.read_text() if arguments.out.exists() else "")
    for name in arguments.only:
        FIGURES[name](table, arguments.build)
        arguments.out.write_text(
            "# Figures\n\nWritten by `./test --long`. Each row says which commit it is from, and the day; times are of "
            f"{machine()}.\n\n{table.text()}")


if __name__ == "__main__":
    main()

"""Figures of controllers on robots: providers, safe stops, and replay of recordings."""

import os
import subprocess
import sys

from long_tests import last_word, rostest
from table import ROOT


def last_words_of(command, **variables):
    """@param variables of the test's environment
    @return summary of a Python test, and whether it passed"""
    done = subprocess.run(command, capture_output=True, text=True, env=dict(os.environ, **variables))
    words = [line for line in done.stderr.splitlines() if line.startswith(("Ran ", "OK", "FAILED"))]
    return "; ".join(words) or "did not run", done.returncode == 0 and "skipped" not in done.stderr


def conformance(table, build):
    test = build / "devel/lib/swarmanoid_experiments/swarmanoid_experiments_conformance_test"
    done = subprocess.run([test], capture_output=True, text=True)
    table.add("conformance test, in process: footbot in kinematics2d, dynamics2d, dynamics3d; eyebot, handbot; wrong wires",
              "passes; each wrong wire is found and named", last_word(done.stdout), done.returncode == 0)
    for name, what in (("conformance", "simulator in lockstep, in other processes"),
                       ("conformance_topics", "simulator over standard topics, in real time; replay of the hosts' frames")):
        table.add(f"conformance test, {what}", "passes", *rostest(name))


def stops(table):
    table.add("safe stop of footbot, eyebot, handbot: exception, lost sensors, SIGINT; watchdogs of drivers",
              "within one control period of the exception, the stated time-out of lost sensors",
              *rostest("robot_safe_stop"))
    table.add("missing devices, overruns, devices that are not listed", "named; reported; silent",
              *rostest("robot_host"))


def workspace(table, build):
    table.add("robot-only workspace: four packages built, controllers of the experiments on simulated robots over topics",
              "builds and runs; no ODE, Box2D, simulator package", *last_words_of([sys.executable, ROOT / "scripts/robot_test.py", build]))


def replay(table):
    table.add("a retrieval run recorded and replayed, all four robots; a changed parameter; bad bags",
              "all ticks equal; the first that differs is named",
              *last_words_of([sys.executable, ROOT / "src/swarmanoid_experiments/test/replay_test.py"]))
    table.add("the same, recorded with controllers in other processes", "all ticks equal", *rostest("replay"))
    table.add("a controller in Python, in lockstep, against the same in C++; robots commanded over topics",
              "equal state hash each tick", *rostest("topics"))


def robots(table, build):
    conformance(table, build)
    stops(table)
    workspace(table, build)
    replay(table)

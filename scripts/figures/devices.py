"""Figures of devices: effort to add one, faults, robots without code, and the amount of code."""

import os
import re
import subprocess
import sys

from long_tests import last_word
from table import ROOT

CODE = ("interface", "hosts", "space", "engines", "experiment_files", "recording", "ros")  # packages
NOT_CODE = {"test", "testing", "benchmark"}


def adding(table, build):
    """Follows docs/how-to in a copy of the tree."""
    done = subprocess.run([sys.executable, ROOT / "scripts/docs_test.py", build,
                           "ListingsTest.test_pages_that_add_to_the_suite_can_be_followed"], capture_output=True, text=True,
                          env=dict(os.environ, DOCS_TEST_LONG="1"))
    seen = [line.split(" ... ")[-1] for line in done.stderr.splitlines()
            if "new files" in line or line.startswith(("Ran ", "OK", "FAILED"))]
    table.add("a ring of light sensors for the footbot and a second implementation of its proximity sensors, added to a copy of the suite "
              "as the pages say: simulator, topic, Python, schema, list, page, errors; then an arena object with a property, a sensor of it "
              "and a rule; then a robot, an engine and a message",
              "at most 5, 2, 8 and 3 new files, no other edited", "; ".join(seen), done.returncode == 0)


def errors(table, build):
    for program, what in (("swarmanoid_space/swarmanoid_space_error_kinds_test", "each kind of error on a chosen field, 10^5 draws"),
                          ("swarmanoid_space/swarmanoid_space_error_chain_test", "errors in a row: order, latency, streams, no allocation"),
                          ("swarmanoid_devices/swarmanoid_devices_error_alias_test", "the devices' own noise parameters, against their old formulas"),
                          ("swarmanoid_experiments/swarmanoid_experiments_error_experiment_test", "errors in experiments: resets, threads")):
        done = subprocess.run([build / "devel/lib" / program], capture_output=True, text=True)
        table.add(what, "as stated, equal bits on repeat", last_word(done.stdout), done.returncode == 0)


def robot_without_code(table, build):
    done = subprocess.run([sys.executable, ROOT / "scripts/outside_test.py", build,
                           "OutsideTest.test_examples_build_and_run_against_devel_and_install_space"], capture_output=True, text=True)
    words = [line for line in done.stderr.splitlines() if line.startswith(("Ran ", "OK", "FAILED"))]
    table.add("an e-puck without code: diffusion in three engines, conformance test, topics under ROS, controller in a process of its own",
              "works, from devel and install spaces", "; ".join(words), done.returncode == 0)


def layers(table):
    done = subprocess.run([sys.executable, ROOT / "scripts/check_layers.py"], capture_output=True, text=True)
    table.add("code of all packages; that of those below outside folders of devices", "names no robot, includes along the arrows only",
              (done.stdout.splitlines() or ["nothing printed"])[-1], done.returncode == 0)


def lines_of_code():
    """Number of lines, without blank lines, comments and tests."""
    count = 0
    for package in CODE:
        for folder, folders, names in os.walk(ROOT / f"src/swarmanoid_{package}"):
            folders[:] = [name for name in folders if name not in NOT_CODE]
            for name in names:
                if name.endswith((".cpp", ".hpp")):
                    with open(os.path.join(folder, name)) as file:
                        count += sum(1 for line in file if not re.match(r"\s*($|//)", line))
    return count


def devices(table, build):
    adding(table, build)
    errors(table, build)
    robot_without_code(table, build)
    layers(table)
    table.add("lines of code of interface, hosts, space, engines, experiment_files, recording and ros, without comments and tests", "reported",
              f"{lines_of_code():,}", None)

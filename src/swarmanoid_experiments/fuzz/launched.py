"""The controllers of misbehaviour.py under roslaunch, which `swarmanoid launch` starts.

roslaunch has the experiment file checked in a separate process before it starts any node, and most actions happen there
already. Each therefore has two cases: one unchanged, and one whose check accepts everything, for the space."""

import os
import pathlib
import random
import re
import signal
import sys
import time

import rosbag

import program
from misbehaviour import BEYOND_REACH, FROM_ENVIRONMENT, PHASES, SIGNALS_OF_ITS_OWN, WATCHDOG, actions

sys.path[:0] = [str(pathlib.Path(__file__).resolve().parents[1] / folder) for folder in ("test", "rostest")]
from misbehaving_world import world  # noqa: E402  pylint: disable=wrong-import-position
from roslaunch_process import free_port  # noqa: E402  pylint: disable=wrong-import-position

STARTS_AND_ENDS = 10.0  # [s] for roslaunch, its master and its nodes, in addition to the limit of the run
LONGEST = program.LONGEST + STARTS_AND_ENDS
PATIENCE = program.PATIENCE + STARTS_AND_ENDS / 2
TICKS = 20
REASON = re.compile(r"swarmanoid: (?!the run has ended without a result).{8,}|\[(ERROR|FATAL)\] .{8,}")
REFUSED = re.compile(r"RLException: .*returned with code \[-?\d+\]")  # message of roslaunch about the check
INTERRUPTED = re.compile(r"process has died \[pid \d+, exit code 130,")
NONE = re.compile("")
RESULT = re.compile(r"(finished|stopped) after (\d+) ticks")
CULPRIT = {"load": "misbehaving_controllers", "factory": "'mc'", "unload": ""}  # of other phases: their robot
ALL_GOOD = '#!/bin/sh\nprintf %s "$PWD/case.xml"\n'


def processes_of(place):
    """Finds processes by the ROS folder in their environment: nodes are in their own sessions. @return their ids"""
    found = []
    for entry in pathlib.Path("/proc").glob("[0-9]*/environ"):
        try:
            if f"ROS_HOME={place}".encode() in entry.read_bytes().split(b"\0"):
                found.append(int(entry.parent.name))
        except OSError:
            pass  # it has ended in the meantime
    return found


def trouble_of_leftovers(place):
    """Kills all processes that have outlived `swarmanoid launch`."""
    time.sleep(0.2)  # for processes that are killed with their parent
    left = {number: pathlib.Path(f"/proc/{number}/cmdline").read_text().replace("\0", " ") for number in processes_of(place)}
    for number in left:
        os.kill(number, signal.SIGKILL)
    return f"left behind: {list(left.values())}" if left else ""


def trouble_of_bag(bag, ticks):
    """@param ticks required in the bag, after the state at the start"""
    try:
        with rosbag.Bag(str(bag)) as opened:
            states = [message.tick for _, message, _ in opened.read_messages(topics=["/space/world_state"])]
    except (OSError, rosbag.ROSBagException) as error:
        return f"no bag to read: {error}"
    return "" if states == list(range(ticks + 1)) else f"{ticks} ticks were run, and the bag has those of the states {states}"


class LaunchedControllers:
    """Each case is a phase, an action and a place. They are shuffled, so that a few cases include all kinds."""

    def __init__(self):
        self._cases = [(phase, action, where) for action in actions() for phase in PHASES for where in ("space", "check")
                       if (phase, where) != ("step", "check")]
        random.Random(0).shuffle(self._cases)
        self.count = len(self._cases)

    @staticmethod
    def _environment(phase, action, where, folder):
        """Returns the environment of roslaunch. Creates the folders in it."""
        environment = {"ROS_HOME": str(folder / "ros"), "ROS_LOG_DIR": str(folder / "ros/log"), "ROS_HOSTNAME": "localhost",
                       "PWD": str(folder), "TMPDIR": str(folder / "temporary")}
        (folder / "temporary").mkdir()
        if phase in FROM_ENVIRONMENT:
            environment["MISBEHAVING"] = f"{phase} {action}"
        if where == "space":
            check = folder / "check/swarmanoid"
            check.parent.mkdir()
            check.write_text(ALL_GOOD)
            check.chmod(0o755)
            environment["PATH"] = f"{check.parent}:{os.environ['PATH']}"
        return environment

    def run(self, _, folder, number):
        phase, action, where = self._cases[number % self.count]
        environment = self._environment(phase, action, where, folder)
        (folder / "case.xml").write_text(world("never" if phase in FROM_ENVIRONMENT else phase, action, maxclock=TICKS))
        ending = program.run(["launch", "case.xml", "rviz:=false", "record:=run.bag", "real_time_factor:=0",
                              f"watchdog:={WATCHDOG}", "-p", free_port()], folder, environment, PATIENCE, LONGEST)
        trouble = [trouble_of_leftovers(folder / "ros"), self._trouble(phase, action, where, ending, folder)]
        return f"{action} in {phase}, {where}", ending, "; ".join(filter(None, trouble))

    @staticmethod
    def _trouble(phase, action, where, ending, folder):
        said = ending.output + ending.errors
        if action in BEYOND_REACH:
            return ending.trouble_of_process(said, NONE, LONGEST)
        is_own = phase == "unload" or action in SIGNALS_OF_ITS_OWN
        if is_own and ending.code == program.BAD_INPUT:
            return ending.trouble_of_process(said, REFUSED, LONGEST)
        # the third signal ends a process at once, and each of the four robots raises one
        if is_own and ending.code == program.STOPPED:
            return ending.trouble_of_process(said, INTERRUPTED, LONGEST)
        trouble = ending.trouble_of_process(said, REASON, LONGEST)
        if trouble:
            return trouble
        if os.listdir(folder / "temporary"):
            return f"left behind: {os.listdir(folder / 'temporary')}"
        is_named = ending.code in (program.BAD_INPUT, program.CONTROLLER_FAILED) and action != "clear_environment"
        if is_named and CULPRIT.get(phase, "fb_4") not in said:
            return "it is not said who it was"
        result = RESULT.search(said)
        if not result and action != "close_output":  # which loses the result
            is_run = where == "space" and phase not in ("load", "factory", "init") and ending.code != program.INTERRUPTED
            return "no result" if is_run else ""
        return trouble_of_bag(folder / "run.bag", int(result[2]) if result else TICKS)

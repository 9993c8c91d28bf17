"""Figures of controllers in other processes, in lockstep with the simulator."""

import contextlib
import os
import pathlib
import signal
import subprocess
import tempfile

import rospy
from swarmanoid_msgs.srv import SetCommandSource

from launched import TIMEOUT, Launched
from long_tests import rostest
from table import ROOT, run

SEEDS = range(1, 21)
STARTS = 20  # per experiment
CONTROLLERS = {"fb_1": "footbot_retrieval", "fb_2": "footbot_retrieval", "fb_3": "footbot_retrieval",
               "eb": "eyebot_retrieval"}
CROWD = [f"fb_{i}" for i in range(1, 21)]


class Elsewhere:
    """Controllers in a separate process, started by launch/robot.launch."""

    def __init__(self, space, robots, controller):
        self.process = subprocess.Popen(
            ["roslaunch", ROOT / "launch/robot.launch", f"robot:={' '.join(robots)}", f"controller:={controller}"],
            stdout=subprocess.DEVNULL, stderr=subprocess.STDOUT, start_new_session=True,
            env=dict(os.environ, ROS_HOME=str(space.path / "ros")))

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.send_signal(signal.SIGINT)
        self.process.wait(TIMEOUT)


def processor_time(*launches):
    """Processor time of the processes that these launches started [s]."""
    ticks = 0
    for stat in pathlib.Path("/proc").glob("[0-9]*/stat"):
        with contextlib.suppress(FileNotFoundError, ProcessLookupError):
            fields = stat.read_text().rpartition(")")[2].split()
            if int(fields[1]) in [launch.process.pid for launch in launches]:
                ticks += int(fields[11]) + int(fields[12])
    return ticks / os.sysconf("SC_CLK_TCK")


class Sums:
    """Ticks and their time, summed over several runs."""

    def __init__(self):
        self.ticks = 0
        self.wall_s = self.processor_s = 0.0

    def add(self, space, launches):
        before = processor_time(*launches)
        ticks, seconds = space.run_to_end()
        self.ticks += ticks
        self.wall_s += seconds
        self.processor_s += processor_time(*launches) - before

    def speed(self):
        return self.ticks / self.wall_s

    def text(self):
        return f"{self.speed():,.0f} ticks/s, {self.processor_s / self.ticks * 1e6:,.0f} us of processors a tick"


def set_source(names, source):
    answer = rospy.ServiceProxy("/space/set_command_source", SetCommandSource)(names=names, source=source)
    if not answer.success:
        raise RuntimeError(answer.message)


def here_and_there(launch, processes, seeds, expected):
    """Makes runs with controllers in other processes, and the same runs of the same space with all controllers in its process.
    @param processes (robots, controller) for each; @param expected hashes by seed; without an entry the run in process counts
    @return sums of both, and the seeds with unequal hashes @throws RuntimeError if a run does not finish"""
    robots = [robot for names, _ in processes for robot in names]
    there, here, unequal = Sums(), Sums(), []
    with Launched("hashes:=hashes.txt", "lockstep_policy:=stop", "lockstep_timeout:=10", *launch) as space, \
            contextlib.ExitStack() as started:
        space.wait_for_service("/space/set_command_source")
        set_source(robots, "remote")
        launches = [space] + [started.enter_context(Elsewhere(space, *process)) for process in processes]
        space.step(10)  # the first tick waits for all processes
        for seed in seeds:
            space.reset(seed=seed)  # the controllers in process command all robots again
            here.add(space, launches)
            alone = (space.path / "hashes.txt").read_text()
            space.reset(seed=seed)
            set_source(robots, "remote")
            there.add(space, launches)
            if not (space.path / "hashes.txt").read_text() == alone == expected.get(seed, alone):
                unequal.append(seed)
    return there, here, unequal


def add_rows(table, what, least, launch, processes, seeds, expected):
    promised = "equal state hash each tick, as in process" + (" and as without ROS" if expected else "")
    try:
        there, here, unequal = here_and_there(launch, processes, seeds, expected)
    except RuntimeError as error:
        table.add(what, promised, str(error), False)
        return
    table.add(what, promised, f"not equal for seeds {unequal}" if unequal else
              f"equal over {there.ticks:,} ticks of {len(seeds)} seeds", not unequal)
    table.add(f"{what}: speed", f"at least {least:,} ticks/s" if least else "reported",
              f"{there.text()}; in process {here.text()}; {there.speed() / here.speed():.0%} of that speed",
              there.speed() >= least if least else None)


def retrieval(table):
    expected = {}
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "hashes.txt"
        for seed in SEEDS:
            run("object_retrieval", "--seed", seed, "--force", "--hashes", file)
            expected[seed] = file.read_text()
    for what, least, robots in (("all four robots commanded by processes of their own", 2500, list(CONTROLLERS)),
                                ("two robots of four commanded by processes of their own", None, ["fb_2", "eb"])):
        add_rows(table, f"object retrieval in lockstep, {what}", least, [],
                 [([robot], CONTROLLERS[robot]) for robot in robots], SEEDS, expected)


def crowd(table):
    add_rows(table, f"diffusion in lockstep, {len(CROWD)} footbots commanded by one other process", 5000,
             ["experiment:=diffusion", f"set:=arena.distribute.quantity={len(CROWD)}"], [(CROWD, "diffusion")],
             range(1, 6), {})


def accidents(table):
    table.add("kill -9 of a process that commands a robot, in a run, and its restart: policies wait, skip, stop",
              "as the policy says, no wait beyond the time-out", *rostest("lockstep_policies"))


def starts(table):
    """Each installed experiment at all paces: a participant registers and the run continues."""
    file = ROOT / "src/swarmanoid_experiments/rostest/lockstep_start_test.py"
    done = subprocess.run([file], capture_output=True, text=True, env=dict(os.environ, LOCKSTEP_STARTS=str(STARTS)))
    words = [line for line in done.stderr.splitlines() if line.startswith(("Ran ", "OK", "FAILED"))]
    table.add(f"a participant registers and runs, at factor 0, 1, 10, paused or not; all installed experiments, {STARTS} starts each",
              "always; services answer while the first tick waits", "; ".join(words), done.returncode == 0)


def two_hosts(table):
    add_row_of_hosts(table, "lockstep", "the eyebot's controller on another host (network namespaces): a slow link, and one "
                     "that is cut for 2 s; policies wait, skip, stop",
                     "equal state hash each tick where all is waited for; as the policy says")
    add_row_of_hosts(table, "topics", "a footbot's controller on another host, over standard topics: the link is cut for 2 s",
                     "the robot stops by itself, and goes on when the link is back")


def add_row_of_hosts(table, test, what, promise):
    file = ROOT / f"src/swarmanoid_experiments/rostest/two_hosts_{test}_test.py"
    done = subprocess.run([file], capture_output=True, text=True)
    speed = [line for line in done.stdout.splitlines() if line.endswith("ticks/s")]
    words = [line for line in done.stderr.splitlines() if line.startswith(("Ran ", "OK", "FAILED")) or "skipped '" in line]
    table.add(what, promise, "; ".join(words + speed), done.returncode == 0 and "skipped" not in done.stderr)


def lockstep(table):
    retrieval(table)
    crowd(table)
    accidents(table)
    starts(table)
    two_hosts(table)

"""Figures of studies with killed processes, and of studies on a cluster."""

import contextlib
import csv
import os
import pathlib
import random
import re
import shlex
import subprocess
import tempfile
import time

import psutil

from cluster_network import ClusterNetwork
from launched import free_port
from studies import FOLDER, call
from table import ROOT

STUDY = FOLDER / "phototaxis.xml"
PAGE = ROOT / "docs/how-to/run_a_batch.md"
RUNS = 300
BATCH = ("batch", "object_retrieval", "--seeds", f"1..{RUNS}", "--no-report")
KILLS = 20
PATIENCE_S = 120
HOSTS_OF_WORKERS = """
import sys
from distributed import Client
client = Client(sys.argv[1])
client.wait_for_workers(int(sys.argv[2]), timeout=60)
print(len({worker["host"] for worker in client.scheduler_info()["workers"].values()}))
"""


def rows(path):
    """Rows of a batch, without the column of wall time."""
    with open(path, newline="") as file:
        head, *found = csv.reader(file)
    wall = head.index("wall_s")
    return sorted(tuple(value for column, value in enumerate(row) if column != wall) for row in found)


def start(folder, *words):
    """Starts a program in a folder, and discards its output."""
    return subprocess.Popen(list(map(str, words)), cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)


def descendants(program):
    with contextlib.suppress(psutil.NoSuchProcess):
        return psutil.Process(program.pid).children(recursive=True)
    return []


def kill(program):
    """Sends SIGKILL, and waits until the child processes have ended, too."""
    others = descendants(program)
    program.kill()
    program.wait(PATIENCE_S)
    if psutil.wait_procs(others, timeout=PATIENCE_S)[1]:
        raise RuntimeError("workers outlive the program")


def worker_of(program, chance):
    """Waits for processes that make runs. @return one of them, or None if the program has ended"""
    while program.poll() is None:
        workers = [child for child in descendants(program) if any("spawn_main" in word for word in child.cmdline())]
        if workers:
            return chance.choice(workers)
        time.sleep(0.01)
    return None


def kill_a_worker(folder, chance, seconds):
    program = start(folder, "swarmanoid", *BATCH, "--jobs", 2, "--out", "killed.csv", "--quiet")
    time.sleep(seconds)
    worker = worker_of(program, chance)
    if worker is not None:
        worker.kill()
    program.wait(PATIENCE_S)


def kill_the_command(folder, _chance, seconds):
    program = start(folder, "swarmanoid", *BATCH, "--jobs", 2, "--out", "killed.csv", "--quiet")
    time.sleep(seconds)
    kill(program)


def kill_the_scheduler(folder, _chance, seconds):
    address = f"tcp://127.0.0.1:{free_port()}"
    scheduler = start(folder, "dask-scheduler", "--host", "127.0.0.1", "--port", address.rpartition(":")[2], "--no-dashboard")
    worker = start(folder, "swarmanoid", "worker", address, "--jobs", 2, "--death-timeout", 5)
    batch = start(folder, "swarmanoid", *BATCH, "--scheduler", address, "--out", "killed.csv", "--quiet")
    time.sleep(seconds)
    scheduler.kill()
    for program in (scheduler, batch, worker):
        program.wait(PATIENCE_S)


def kills(table):
    """Kills at random times, some of them before the first run and after the last one."""
    chance = random.Random(time.time_ns())
    good = 0
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        begin = time.monotonic()
        call(folder, *BATCH, "--jobs", 2, "--out", "whole.csv")
        whole_s = time.monotonic() - begin
        expected = rows(folder / "whole.csv")
        for number in range(KILLS):
            (kill_a_worker, kill_the_command, kill_the_scheduler)[number % 3](folder, chance, chance.uniform(0.0, whole_s))
            is_begun = (folder / "killed.csv").exists()
            call(folder, *BATCH, "--jobs", 2, "--out", "killed.csv", *(["--resume"] if is_begun else []))
            good += rows(folder / "killed.csv") == expected
            (folder / "killed.csv").unlink()
    table.add(f"batch of {RUNS} runs of object_retrieval: kill -9 of a worker, of the command, of the scheduler, in turn, at random "
              f"times, {KILLS} times; then --resume", "the rows of a batch that nobody kills, each once",
              f"equal in {good} of {KILLS}", good == KILLS)


def workers(table):
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)

        def evolved(out):
            return [(folder / out / file).read_bytes() for file in ("checkpoint.json", "generations.csv", "best.xml")]

        for jobs in (1, 2, 4):
            call(folder, "evolve", STUDY, "--jobs", jobs, "--out", f"of_{jobs}")
        program = start(folder, "swarmanoid", "evolve", STUDY, "--jobs", 2, "--out", "killed", "--quiet")
        while not (folder / "killed/checkpoint.json").exists():
            time.sleep(0.05)
        worker_of(program, random.Random(1)).kill()
        time.sleep(3.0)
        kill(program)
        call(folder, "evolve", STUDY, "--jobs", 2, "--out", "killed", "--resume")
        equal = [evolved(out) == evolved("of_1") for out in ("of_2", "of_4", "killed")]
    table.add("the study phototaxis with 1, 2, 4 processes, and with a worker and then the command killed and --resume",
              "equal genotypes, to the last bit", f"equal to those of one process: {sum(equal)} of {len(equal)}", all(equal))


def page_commands():
    """@return the commands of the scheduler, a worker and the batch in the how-to, as words"""
    text = PAGE.read_text()
    found = [re.search(pattern, text, re.MULTILINE) for pattern in
             (r"^    (dask-scheduler --host 10\.0\.0\.1 .*?)(?:#|$)", r"^    (swarmanoid worker tcp://10\.0\.0\.1:\d+) +#",
              r"^    (swarmanoid batch EXPERIMENT .*10\.0\.0\.1:\d+)$")]
    if not all(found):
        raise RuntimeError(f"{PAGE}: found no commands for a cluster on 10.0.0.1")
    return [shlex.split(each.group(1)) for each in found]


def cluster(table):
    scheduler, worker, batch = page_commands()
    replaced = {"EXPERIMENT": "object_retrieval", "1..10000": f"1..{RUNS}"}
    batch = [replaced.get(word, word) for word in batch] + ["--no-report", "--quiet", "--out", "cluster.csv"]
    with tempfile.TemporaryDirectory() as name, ClusterNetwork(6) as network:
        folder = pathlib.Path(name)
        call(folder, *BATCH, "--out", "here.csv")
        start(folder, *network.command(0, scheduler))
        for host in (1, 2, 3, 4):
            start(folder, *network.command(host, worker))
        ask = ["/usr/bin/python3", "-c", HOSTS_OF_WORKERS, batch[batch.index("--scheduler") + 1], str(4 * len(os.sched_getaffinity(0)))]
        hosts = subprocess.run(network.command(5, ask), capture_output=True, text=True, check=True).stdout.strip()
        done = subprocess.run(network.command(5, batch), cwd=folder, capture_output=True, text=True, timeout=PATIENCE_S)
        is_equal = done.returncode == 0 and rows(folder / "cluster.csv") == rows(folder / "here.csv")
    seen = "equal" if is_equal else f"not equal; exit code {done.returncode}, {done.stderr.strip()}"
    table.add("a scheduler, four workers and the command, each on a host of its own (network namespaces), started as the how-to says",
              "the rows of one computer", f"{seen}; workers on {hosts} hosts", is_equal and hosts == "4")

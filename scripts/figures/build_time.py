"""Time from a fresh clone, or on a fresh machine, to the end of a run or of the tests."""

import pathlib
import resource
import subprocess
import sys
import tempfile
import time

from table import ROOT

sys.path.insert(0, str(ROOT / "scripts"))
from surroundings import outside_of_workspaces  # noqa: E402  pylint: disable=wrong-import-position


def processor_time():
    """Processor time of all child processes that were waited for [s]."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def in_fresh_clone(*command):
    """Runs a command in a fresh clone, without a compiler cache. Packages are already installed.
    @return the completed process, minutes, core minutes"""
    with tempfile.TemporaryDirectory() as folder:
        clone = pathlib.Path(folder) / "swarmanoid"
        environment = dict(outside_of_workspaces(), CCACHE_DISABLE="1")
        start, start_used = time.monotonic(), processor_time()
        subprocess.run(["git", "clone", "--quiet", ROOT, clone], check=True)
        done = subprocess.run(command, capture_output=True, text=True, env=environment, cwd=clone)
        return done, (time.monotonic() - start) / 60, (processor_time() - start_used) / 60


def add_time(table, what, promised_minutes, done, minutes, core_minutes, seen=""):
    good = done.returncode == 0
    table.add(what, f"at most {promised_minutes} minutes",
              f"{minutes:.1f} minutes, {core_minutes:.1f} core minutes{seen}" if good else f"failed: {done.stdout[-200:]}",
              good and minutes <= promised_minutes)


def fresh_clone(table):
    add_time(table, "git clone and ./run --headless, after apt, without a compiler cache", 3,
             *in_fresh_clone("./run", "--headless"))


def fresh_tests(table):
    done, *times = in_fresh_clone("./test")
    closing = next((line for line in done.stdout.splitlines() if "tests passed" in line), "no closing line")
    add_time(table, "git clone and ./test, after apt, without a compiler cache", 20, done, *times, f"; {closing}")


def fresh_machines(table, *command):
    """Runs a command on minimal systems, on which apt installs all packages."""
    done = subprocess.run([ROOT / "scripts/fresh_machine.py", *command], capture_output=True, text=True)
    lines = [line for line in done.stdout.splitlines() if line.startswith(("Debian", "state hashes"))]
    closing = done.stdout.splitlines()[-1] if done.stdout else "nothing printed"
    table.add(f"{' '.join(command)} on a minimal Debian 12 and 13", "passes in both", "; ".join([*lines, closing]),
              done.returncode == 0 and closing.startswith("2 passed"))

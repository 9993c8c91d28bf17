"""From a fresh clone to the end of a run."""

import os
import pathlib
import resource
import subprocess
import tempfile
import time

from table import ROOT

MOST_SECONDS = 360


def processor_time():
    """Of all processes that were waited for [s]."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def fresh_clone(table):
    """Everything is compiled: no cache. Packages are there already, as after apt."""
    with tempfile.TemporaryDirectory() as folder:
        clone = pathlib.Path(folder) / "swarmanoid"
        # what a devel space put into the environment would be found instead of what is built here
        ours = ("CMAKE_PREFIX_PATH", "LD_LIBRARY_PATH", "PKG_CONFIG_PATH", "PYTHONPATH", "ROS_PACKAGE_PATH")
        environment = {name: value for name, value in os.environ.items() if name not in ours}
        environment["CCACHE_DISABLE"] = "1"
        start, start_used = time.monotonic(), processor_time()
        subprocess.run(["git", "clone", "--quiet", ROOT, clone], check=True)
        done = subprocess.run([clone / "run", "--headless"], capture_output=True, text=True, env=environment)
        seconds, used = time.monotonic() - start, processor_time() - start_used
        good = done.returncode == 0 and '"success":true' in done.stdout
        table.add("git clone and ./run --headless, after apt, without a compiler cache", "done in under 6 minutes",
                  f"{seconds / 60:.1f} minutes, {used / 60:.1f} core minutes" if good else f"failed: {done.stderr[-200:]}",
                  good and seconds < MOST_SECONDS)

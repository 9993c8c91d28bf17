"""`swarmanoid worker`: processes that make runs for the scheduler of a cluster; starts a Dask worker with the required settings."""

import os
import sys

from .mistakes import Arguments, call


def main() -> int:
    return call(_main)


def _main() -> int:
    from .command_options import check_scheduler, check_worker_options
    from .workers import SETUP
    parser = Arguments("worker", "Makes runs for a dask-scheduler, until that ends. What follows goes on to `dask worker`.")
    parser.add_argument("scheduler", help="its address, tcp://host:port")
    parser.add_argument("--jobs", type=int, metavar="N", help="processes that make runs; without it one a processor")
    arguments, others = parser.parse_known_args()
    check_scheduler(arguments.scheduler, "scheduler")
    jobs = check_worker_options(arguments.jobs, None)
    command = [sys.executable, "-m", "distributed.cli.dask_worker", arguments.scheduler, "--nworkers", str(jobs),
               "--nthreads", "1", "--memory-limit", "0", "--no-dashboard", "--preload", SETUP, *others]
    os.execv(sys.executable, command)

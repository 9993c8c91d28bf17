"""Options shared by several commands, and their checks."""

import os
import re
from typing import Optional

from .input_file import shown
from .mistakes import Arguments, BadInput

ADDRESS = re.compile(r"(?:tcp|tls)://(?:[A-Za-z0-9._-]+|\[[0-9A-Fa-f:.]+\]):([0-9]{1,5})")


def add_worker_options(parser: Arguments) -> None:
    parser.add_argument("--jobs", type=int, metavar="N", help="processes that make runs; without it one a processor")
    parser.add_argument("--scheduler", metavar="ADDRESS", help="of a dask-scheduler, tcp://host:port, whose workers make the runs")


def check_scheduler(address: str, option: str = "--scheduler") -> None:
    """@raise BadInput"""
    found = ADDRESS.fullmatch(address)
    if not found or not 0 < int(found[1]) < 65536:
        raise BadInput(f"{option}: found '{shown(address)}', allowed: tcp://host:port, or tls://host:port with certificates in Dask's "
                       "configuration")


def check_worker_options(jobs: Optional[int], scheduler: Optional[str]) -> int:
    """@return number of processes to start; 0 if a scheduler provides them @raise BadInput"""
    from .workers import MOST_JOBS, allow_files
    if jobs is not None and scheduler is not None:
        raise BadInput("found --jobs and --scheduler, allowed: one of them")
    if scheduler is not None:
        check_scheduler(scheduler)
    if jobs is not None and not 1 <= jobs <= MOST_JOBS:
        raise BadInput(f"--jobs: found {jobs}, allowed: 1 to {MOST_JOBS}")
    return allow_files(jobs) if scheduler is None else 0


def refuse_resume_with_force(is_resumed: bool, is_forced: bool) -> None:
    """@raise BadInput"""
    if is_resumed and is_forced:
        raise BadInput("found --resume and --force, allowed: one of them")


def portable(experiment: str) -> str:
    """Name of an experiment for workers: the absolute path of a file, or a name that they look up in their installation."""
    return os.path.abspath(experiment) if os.path.exists(experiment) else experiment

"""Makes runs, in a process of its own.

The simulation of the last request is kept: a next request for the same experiment and overrides resets it with another seed,
without reading the experiment again. Runs have one thread each, since many are made in parallel."""

import contextlib
import os
import socket
import sys
import time
import warnings
from typing import Optional, Tuple

import swarmanoid

from .contents import contents_of, require_same
from .contents_fields import OtherContents
from .runs import RunOutcome, RunRequest, failure_text, lost

_kept: Optional[Tuple[Tuple[object, ...], swarmanoid.Simulation]] = None


def begin(request: RunRequest) -> swarmanoid.Simulation:
    """@return a simulation for the request, before its first tick @raise swarmanoid.ExperimentError"""
    global _kept
    wanted = (request.experiment, request.overrides)
    if _kept is not None and _kept[0] == wanted:
        simulation = _kept[1]
        _kept = None  # a simulation whose run fails is not reused
        simulation.reset(seed=request.seed)
    else:
        _kept = None  # before the new one, to free memory
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # the check of the experiment has shown them
            simulation = swarmanoid.Simulation(request.experiment, seed=request.seed, threads=1,
                                               overrides=dict(request.overrides))
        _refuse_other_contents(simulation, request)
    _kept = (wanted, simulation)
    return simulation


def _refuse_other_contents(simulation: swarmanoid.Simulation, request: RunRequest) -> None:
    """@raise OtherContents"""
    if request.expected is not None:
        require_same(contents_of(simulation), request.expected, f"the worker {os.getpid()} on {socket.gethostname()}")


def make_run(request: RunRequest) -> RunOutcome:
    """@raise OtherContents if the contents differ from the requested ones"""
    global _kept
    start = time.perf_counter()
    try:
        with contextlib.redirect_stdout(sys.stderr):  # output of scripts: standard output carries the result
            simulation = begin(request)
            result = simulation.run()
        _refuse_other_contents(simulation, request)  # scripts are read again for each run
    except OtherContents:
        _kept = None
        raise
    except BaseException as error:  # any exception of user code, even KeyboardInterrupt, goes into the run's row
        _kept = None
        return lost(f"{type(error).__name__}: {error}")._replace(wall_s=time.perf_counter() - start)
    failures = result["failed_controllers"]
    text = ""
    if failures:
        first = failures[0]
        text = f"{len(failures)} controllers failed, first {first['robot']} in tick {first['tick']}: {first['reason']}"
    return RunOutcome(result["metrics"], result["success"], result["ticks"], time.perf_counter() - start,
                      result["state_hash"], failure_text(text), True)

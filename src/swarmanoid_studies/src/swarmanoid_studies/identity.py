"""What makes runs of different days or computers comparable: the suite, its mathematics, the experiment with all its files.

A results file and a checkpoint carry it, and are not continued with another one; workers must have that of the program that
asks them."""

import functools
import hashlib
import subprocess
import warnings
from typing import Mapping

import swarmanoid

from .identity_fields import Identity
from .mistakes import BadInput


@functools.lru_cache(maxsize=1)
def version() -> str:
    """As `swarmanoid --version` prints it."""
    done = subprocess.run(["swarmanoid", "--version"], stdout=subprocess.PIPE, text=True, check=True, stdin=subprocess.DEVNULL)
    return done.stdout.split()[-1]


def checked(experiment: str, overrides: Mapping[str, str]) -> swarmanoid.Simulation:
    """Reads and builds an experiment; warnings go to the error stream. @raise BadInput"""
    try:
        return swarmanoid.Simulation(experiment, threads=1, overrides=dict(overrides))
    except (ValueError, RuntimeError) as error:
        raise BadInput(str(error)) from None


def identity_of(simulation: swarmanoid.Simulation) -> Identity:
    record = simulation.record
    everything = hashlib.sha256(record["text"].encode())
    for name, content in sorted(record["files"].items()):
        everything.update(name.encode() + hashlib.sha256(content).digest())
    for name, library in sorted(record["libraries"].items()):
        everything.update(f"{name} {library}\n".encode())
    return Identity(simulation.result["experiment"], version(), record["math_library"], everything.hexdigest()[:16])


def identify(experiment: str, overrides: Mapping[str, str]) -> Identity:
    """Of the experiment as this process finds it: asked of each worker."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        return identity_of(checked(experiment, overrides))

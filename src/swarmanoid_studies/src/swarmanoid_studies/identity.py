"""Identity of runs: the suite, its mathematics library, and the experiment with all its files. Runs with equal identity are
comparable, also if made on other days or computers.

Results files and checkpoints contain it, and are not continued with another one; workers must have the identity of the program."""

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
    """The version that `swarmanoid --version` prints."""
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
    """Identity of the experiment in this process; the program calls it in each worker."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        return identity_of(checked(experiment, overrides))

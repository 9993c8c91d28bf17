"""Check that workers use the same contents as the program: the suite and its mathematics library, the experiment, the files that it
names, the imports of its scripts, and the libraries.

The identity (identity.py) is compared once, when runs begin. Files may change while runs are made, and workers may join later, so
each worker checks before its first run of an experiment and after each run."""

import hashlib
import os
import sys
from typing import FrozenSet, Iterable

import numpy
import swarmanoid
from swarmanoid import _scripts

from .contents_fields import Contents, OtherContents
from .identity import version

EXPERIMENT = "the experiment file"


def _digest(content: bytes) -> FrozenSet[str]:
    return frozenset((hashlib.sha256(content).hexdigest()[:16],))


def _read(path: str) -> bytes:
    """@return the content; b"" if the file no longer exists"""
    try:
        with open(path, "rb") as file:
            return file.read()
    except OSError:
        return b""


def contents_of(simulation: swarmanoid.Simulation) -> Contents:
    """Contents by the current files. @pre the simulation is new, or its run just over @raise OtherContents if a file is missing"""
    try:
        record = simulation.record
    except (RuntimeError, ValueError) as error:
        raise OtherContents(str(error)) from None
    digests = {EXPERIMENT: _digest(_read(record["file"]))}
    for name, content in record["files"].items():
        named = os.path.basename(name).partition("_")[2]   # "files/1_floor.png"
        digests[named] = digests.get(named, frozenset()) | _digest(content)
    for name, value in record["libraries"].items():
        digests[name] = frozenset((value,))
    for path in _scripts.files_read():
        digests[os.path.basename(path)] = digests.get(os.path.basename(path), frozenset()) | _digest(_read(path))
    return Contents(version(), record["math_library"], sys.version.split()[0], numpy.__version__, digests)


def merged(contents: Iterable[Contents]) -> Contents:
    """Union of contents: runs of a batch with other values may name other files. @param contents at least one"""
    first, *others = contents
    digests = dict(first.digests)
    for other in others:
        for name, values in other.digests.items():
            digests[name] = digests.get(name, frozenset()) | values
    return first._replace(digests=digests)


def require_same(own: Contents, expected: Contents, worker: str) -> None:
    """@param worker for the message @raise OtherContents"""
    for name in ("version", "math_library", "python", "numpy"):
        if getattr(own, name) != getattr(expected, name):
            raise OtherContents(f"{worker} makes other runs: {name}: found '{getattr(own, name)}', allowed: "
                                f"'{getattr(expected, name)}', as here")
    for name, values in own.digests.items():
        if name in expected.digests and not values <= expected.digests[name]:
            raise OtherContents(f"{name} has changed since the runs began; rows so far are of what it was")

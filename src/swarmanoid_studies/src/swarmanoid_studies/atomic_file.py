"""Files that are replaced atomically, and written by one program at a time."""

import fcntl
import os
import tempfile
from typing import Tuple

from .mistakes import BadInput, RunsStopped


def unwritable(path: str, error: OSError) -> RunsStopped:
    """The error for a write that fails after the file was opened: the disk is full, or a limit is reached."""
    return RunsStopped(f"{path}: cannot be written: {error.strerror or error}")


def refuse_unwritable(path: str) -> None:
    """Checks a path before long computations. @raise BadInput if `write_atomically` cannot write the file"""
    try:
        if os.path.isdir(path):
            raise BadInput(f"{path}: found a folder, allowed: a file")
        number, name = _beside(path)
        os.close(number)
        os.unlink(name)
    except (OSError, ValueError) as error:  # ValueError: an invalid file name
        raise BadInput(f"{path}: cannot be written: {getattr(error, 'strerror', None) or error}") from None


def _beside(path: str) -> Tuple[int, str]:
    """Creates a temporary file in the same folder."""
    return tempfile.mkstemp(prefix=f".{os.path.basename(path)}.", dir=os.path.dirname(os.path.abspath(path)))


def write_atomically(path: str, content: bytes) -> None:
    """Replaces a file; a crash of the program or the computer leaves the old or the new content. @raise RunsStopped"""
    try:
        _replace(path, content)
    except OSError as error:
        raise unwritable(path, error) from None


def _replace(path: str, content: bytes) -> None:
    number, name = _beside(path)
    try:
        with os.fdopen(number, "wb") as file:
            file.write(content)
            file.flush()
            os.fsync(file.fileno())
        mask = os.umask(0)
        os.umask(mask)
        os.chmod(name, 0o666 & ~mask)
        os.replace(name, path)
    except BaseException:
        os.unlink(name)
        raise


def lock(number: int, path: str) -> None:
    """Locks a file or folder until its descriptor is closed. @raise BadInput if another program has locked it"""
    try:
        fcntl.flock(number, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        raise BadInput(f"{path}: another program is writing it") from None

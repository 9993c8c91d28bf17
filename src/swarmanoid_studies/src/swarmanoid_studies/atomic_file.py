"""Files that are there as a whole, or as they were, and that one program writes at a time."""

import fcntl
import os
import tempfile

from .mistakes import BadInput


def write_atomically(path: str, content: bytes) -> None:
    """Replaces a file, also when the program or the computer dies meanwhile. @raise OSError"""
    folder = os.path.dirname(os.path.abspath(path))
    number, name = tempfile.mkstemp(prefix=f".{os.path.basename(path)}.", dir=folder)
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
    """Keeps other programs out until the descriptor of the file or folder is closed. @raise BadInput if one has locked it"""
    try:
        fcntl.flock(number, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        raise BadInput(f"{path}: another program is writing it") from None

"""Setup of a worker process."""

import contextlib
import signal


def set_up() -> None:
    from .makers import start
    # all processes of a terminal receive Ctrl-C: the program that started the worker ends it
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    with contextlib.suppress(OSError):  # the first run tries again, and reports the error
        start()


def dask_setup(_worker: object) -> None:
    """Called by `dask worker --preload` of this module."""
    set_up()

"""What a process that makes runs does when it starts."""

import contextlib
import signal


def set_up() -> None:
    from .makers import start
    # Ctrl-C goes to all processes of a terminal: the program that started the worker ends it
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    with contextlib.suppress(OSError):  # the first run tries again, and reports it
        start()


def dask_setup(_worker: object) -> None:
    """Called by `dask worker --preload` of this module."""
    set_up()

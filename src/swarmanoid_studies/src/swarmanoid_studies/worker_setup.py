"""What a Dask worker does when it starts (its option `preload`)."""

import signal

import swarmanoid  # noqa: F401  the first run need not wait for it


def dask_setup(_worker: object) -> None:
    # Ctrl-C goes to all processes of a terminal: whoever has started the worker ends it
    signal.signal(signal.SIGINT, signal.SIG_IGN)

"""The body of a process that makes runs for a worker, see makers.py. Whatever goes wrong in it, it ends without a word: the worker
sees that, and reports it in a row."""

import os
import select
import signal
import sys
import threading
from multiprocessing.connection import Connection


def _end_with(parent: int) -> None:
    """Ends this process, and what it has started, when the worker ends, also in the middle of a run."""
    try:
        life = os.pidfd_open(parent)
        if os.getppid() == parent:
            select.select([life], [], [])
    finally:
        os.killpg(0, signal.SIGKILL)


def _serve(connection: Connection) -> None:
    from .contents_fields import OtherContents
    from .run_maker import make_run
    connection.send("up")
    while True:
        for request in connection.recv():
            try:
                answer: object = make_run(request)
            except OtherContents as others:
                answer = others
            connection.send(answer)


def main() -> None:
    """Arguments: the number of the connection, and the worker's process."""
    connection, parent = int(sys.argv[1]), int(sys.argv[2])
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    threading.Thread(target=_end_with, args=(parent,), daemon=True).start()
    try:
        _serve(Connection(connection))
    except BaseException:  # pylint: disable=broad-except
        os._exit(1)

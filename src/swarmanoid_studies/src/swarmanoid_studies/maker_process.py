"""The body of a process that makes runs for a worker, see makers.py. On any error it ends silently; the worker detects that, and
reports it in a row."""

import fcntl
import os
import select
import signal
import sys
from multiprocessing.connection import Connection


def _end_with_worker(life: int) -> None:
    """Ends this process and its children when the worker ends, also in the middle of a run. The kernel does it, since user code may
    never release the GIL. @param life a pipe whose other end only the worker has"""
    fcntl.fcntl(life, fcntl.F_SETOWN, -os.getpid())   # the group
    fcntl.fcntl(life, fcntl.F_SETSIG, signal.SIGKILL)
    fcntl.fcntl(life, fcntl.F_SETFL, fcntl.fcntl(life, fcntl.F_GETFL) | os.O_ASYNC)
    if select.select([life], [], [], 0)[0]:           # the worker has already ended
        os.killpg(0, signal.SIGKILL)


def _serve(connection: Connection) -> None:
    """Sends the reason why it cannot start, or an empty string, and then an answer to each request."""
    try:
        from .contents_fields import OtherContents
        from .run_maker import make_run
    except Exception as error:  # such as a missing library
        connection.send(f"{type(error).__name__}: {error}")
        raise
    connection.send("")
    while True:
        for request in connection.recv():
            try:
                answer: object = make_run(request)
            except OtherContents as others:
                answer = others
            connection.send(answer)


def main() -> None:
    """Arguments: the descriptors of the connection, and of a pipe that closes when the worker ends."""
    connection, life = int(sys.argv[1]), int(sys.argv[2])
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    try:
        _end_with_worker(life)
        _serve(Connection(connection))
    except BaseException:  # pylint: disable=broad-except
        os._exit(1)

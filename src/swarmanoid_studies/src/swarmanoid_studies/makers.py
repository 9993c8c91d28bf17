"""The process in which a worker has its runs made.

Controllers, rules and libraries of users may crash, close files that are not theirs, or send signals: that ends their process, the
maker, and not the worker, which then starts another one. So a worker can tell which run it was, and no other run is lost."""

import os
import signal
import socket
import subprocess
import sys
import time
from multiprocessing import Pipe
from multiprocessing.connection import Connection, wait
from typing import Iterator, List, Optional, Sequence

from .contents_fields import OtherContents
from .mistakes import RunsStopped
from .runs import RunOutcome, RunRequest, lost, one_line

MOST_TRIES = 3           # of a run: its process may have been ended by others
MOST_FAILED_STARTS = 10  # one after another
MAIN = "from swarmanoid_studies.maker_process import main; main()"

_maker: Optional["_Maker"] = None


class _Ended(Exception):
    """The maker is gone, and how."""


class _Maker:
    """A process, from its start on; it ends with this one."""

    def __init__(self) -> None:
        own, its = socket.socketpair()
        worker_lives, self._worker_lives = Pipe(duplex=False)   # only this process has the end that is written to
        with its, worker_lives:
            numbers = [its.fileno(), worker_lives.fileno()]
            # -P: modules are not looked for in the current folder. A session of its own: signals that user code sends to its group
            # reach nothing else. Standard output is the program's
            self._process = subprocess.Popen([sys.executable, "-P", "-c", MAIN, *map(str, numbers)], stdout=2,
                                             stdin=subprocess.DEVNULL, pass_fds=numbers, start_new_session=True)
        self._connection = Connection(own.detach())
        self._life = os.pidfd_open(self._process.pid)
        self._is_up = False

    def wait_until_up(self) -> None:
        """@raise _Ended, RunsStopped"""
        if not self._is_up:
            problem = self._receive()
            if problem:
                raise RunsStopped(f"a process that makes runs cannot be started: {one_line(str(problem))}")
            self._is_up = True

    def outcomes(self, requests: Sequence[RunRequest]) -> Iterator[RunOutcome]:
        """@raise _Ended, OtherContents"""
        try:
            self._connection.send(list(requests))
        except OSError:
            raise self._ended() from None
        for _ in requests:
            answer = self._receive()
            if isinstance(answer, OtherContents):
                raise answer
            yield answer

    def _receive(self) -> object:
        """Not by waiting for the end of the connection alone: processes that user code has started may hold it open."""
        wait([self._connection, self._life])
        try:
            if self._connection.poll():
                return self._connection.recv()
        except (EOFError, OSError):
            pass
        raise self._ended()

    def _ended(self) -> _Ended:
        has_ended = wait([self._life], timeout=1.0)   # it may be about to; its number stays its own until `end` has used it
        self.end()
        if not has_ended:
            return _Ended("it closed its connection")
        code = self._process.returncode
        return _Ended(f"by {_name(-code)}" if code < 0 else f"with exit code {code}")

    def end(self) -> None:
        if self._connection.closed:
            return
        try:
            os.killpg(self._process.pid, signal.SIGKILL)   # and what it has started
        except ProcessLookupError:
            pass
        self._process.wait()
        self._connection.close()
        self._worker_lives.close()
        os.close(self._life)


def _name(number: int) -> str:
    """Of a signal; those of real time have none."""
    try:
        return signal.Signals(number).name
    except ValueError:
        return f"signal {number}"


def start() -> None:
    """Begins a maker, so that the first run need not wait for it."""
    global _maker
    _maker = _maker or _Maker()


def stop() -> None:
    """Ends the maker, if there is one."""
    global _maker
    if _maker is not None:
        _maker.end()
        _maker = None


def _running() -> _Maker:
    """@raise RunsStopped"""
    problem = ""
    for _ in range(MOST_FAILED_STARTS):
        try:
            start()
            _maker.wait_until_up()
            return _maker
        except _Ended as ended:
            problem = f"{MOST_FAILED_STARTS} ended as they began, the last one {ended}"
            stop()
        except OSError as error:
            raise RunsStopped(f"a process that makes runs cannot be started: {error.strerror}") from None
    raise RunsStopped(f"processes that make runs cannot be started: {problem}")


def make_runs(requests: Sequence[RunRequest]) -> List[RunOutcome]:
    """Called in a worker, by one thread at a time. @raise OtherContents, RunsStopped"""
    made: List[RunOutcome] = []
    tries, start_s = 0, time.perf_counter()
    while len(made) < len(requests):
        try:
            for outcome in _running().outcomes(requests[len(made):]):
                made.append(outcome)
                tries, start_s = 0, time.perf_counter()
        except _Ended as ended:
            stop()
            tries += 1
            if tries == MOST_TRIES:
                reason = f"the process that made the run ended in it, each of {MOST_TRIES} times, {ended}"
                made.append(lost(reason)._replace(wall_s=time.perf_counter() - start_s))
                tries, start_s = 0, time.perf_counter()
        except BaseException:
            stop()   # it may have more of the requests before it, or have sent a part of an answer
            raise
    return made

"""The maker: a separate process that makes the runs of a worker.

Controllers, rules and libraries of users may crash, close foreign files, or send signals. This ends the maker and not the worker,
which then starts another maker. So the worker knows which run failed, and no other run is lost."""

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

MOST_TRIES = 3           # per run: other programs may have ended its process
MOST_FAILED_STARTS = 10  # in a row
MAIN = "from swarmanoid_studies.maker_process import main; main()"

_maker: Optional["_Maker"] = None


class _Ended(Exception):
    """The maker has ended; the message has its signal or exit code."""


class _Maker:
    """A running maker; it ends with this process."""

    def __init__(self) -> None:
        own, its = socket.socketpair()
        worker_lives, self._worker_lives = Pipe(duplex=False)   # only this process has the write end
        with its, worker_lives:
            numbers = [its.fileno(), worker_lives.fileno()]
            # -P: no imports from the current folder. A session of its own: signals of user code to its process group do not reach
            # other processes. Standard output is redirected, since it carries the program's result
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
        """Waits for an answer or the end of the process. Waiting for the connection alone is not enough, since child processes
        of user code may hold it open. @raise _Ended"""
        wait([self._connection, self._life])
        try:
            if self._connection.poll():
                return self._connection.recv()
        except (EOFError, OSError):
            pass
        raise self._ended()

    def _ended(self) -> _Ended:
        has_ended = wait([self._life], timeout=1.0)   # it may be about to end; its pid is not reused before `end` waits for it
        self.end()
        if not has_ended:
            return _Ended("it closed its connection")
        code = self._process.returncode
        return _Ended(f"by {_name(-code)}" if code < 0 else f"with exit code {code}")

    def end(self) -> None:
        if self._connection.closed:
            return
        try:
            os.killpg(self._process.pid, signal.SIGKILL)   # with its child processes
        except ProcessLookupError:
            pass
        self._process.wait()
        self._connection.close()
        self._worker_lives.close()
        os.close(self._life)


def _name(number: int) -> str:
    """Name of a signal; real-time signals have only numbers."""
    try:
        return signal.Signals(number).name
    except ValueError:
        return f"signal {number}"


def start() -> None:
    """Starts a maker if there is none, so that the first run does not wait for it."""
    global _maker
    _maker = _maker or _Maker()


def stop() -> None:
    """Ends the maker, if there is one."""
    global _maker
    if _maker is not None:
        _maker.end()
        _maker = None


def _running() -> _Maker:
    """Starts a maker if necessary, and waits until it is up. @raise RunsStopped"""
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
    """Makes runs, in a worker, by one thread at a time. @raise OtherContents, RunsStopped"""
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
            stop()   # it may have pending requests, or have sent a part of an answer
            raise
    return made

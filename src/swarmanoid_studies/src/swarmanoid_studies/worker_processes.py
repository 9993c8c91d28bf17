"""The processes of this computer that make runs.

Each is a Dask worker, and is restarted if it dies. Dask's own supervisor (nanny) is not used: it waits without end if a process
dies before it has reported its address."""

import asyncio
import multiprocessing
import os
import signal
import threading
from multiprocessing.connection import Connection, wait
from typing import Callable, Dict, Optional

from . import dask_settings  # noqa: F401
from distributed import Worker
from distributed.security import Security

from .mistakes import RunsStopped

METHOD = multiprocessing.get_context("spawn")  # not fork: this process has threads
os.environ.setdefault("PYTHONHASHSEED", "0")    # for the processes: scripts run there as in C++ programs
MOST_FAILED_STARTS = 10  # in a row, over all processes


def _end_with_parent() -> None:
    parent = multiprocessing.parent_process()
    assert parent is not None
    wait([parent.sentinel])
    os._exit(1)


async def _work(scheduler: str, security: Security, listens: Connection) -> None:
    async with Worker(scheduler, nthreads=1, security=security, host="127.0.0.1", memory_limit=0) as worker:
        listens.send(True)
        await worker.finished()


def _main(scheduler: str, security: Security, listens: Connection) -> None:
    # workers end even if the program is killed by SIGKILL, also in the middle of a run
    threading.Thread(target=_end_with_parent, daemon=True).start()
    from .worker_setup import set_up
    set_up()
    asyncio.run(_work(scheduler, security, listens))


class _Process:
    def __init__(self, scheduler: str, security: Security) -> None:
        self.listens, listens = METHOD.Pipe(duplex=False)
        self._process = METHOD.Process(target=_main, args=(scheduler, security, listens), daemon=True)
        self._process.start()
        listens.close()
        self.is_up = False

    def is_alive(self) -> bool:
        """To be called when the process has sent a message or died."""
        try:
            self.is_up = self.listens.recv() or self.is_up
            return True
        except (EOFError, OSError):
            return False

    def end(self) -> None:
        self._process.kill()
        self._process.join()
        self.listens.close()


class WorkerProcesses:
    """A context in which the processes run."""

    def __init__(self, count: int, scheduler: str, security: Security, give_up: Callable[[], object]) -> None:
        """@param give_up called in another thread if processes can no longer be started"""
        self._count = count
        self._make = lambda: _Process(scheduler, security)
        self._give_up = give_up
        self._failed_starts = 0
        self._problem = ""  # reason why processes could not be started
        self._are_settled = threading.Event()
        self._end, self._ends = METHOD.Pipe(duplex=False)
        self._keeper = threading.Thread(target=self._keep, daemon=True)

    def _keep(self) -> None:
        # inherited by the processes: they are ended here, and not by Ctrl-C, which all processes of a terminal receive
        signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT, signal.SIGHUP})
        processes: Dict[object, _Process] = {}
        try:
            self._tend(processes)
        except RunsStopped as stopped:
            self._problem = str(stopped)
            self._are_settled.set()
            self._give_up()
        for process in processes.values():
            process.end()

    def _tend(self, processes: Dict[object, _Process]) -> None:
        """Runs until the context ends, and restarts dead processes. @raise RunsStopped if processes cannot be started"""
        for _ in range(self._count):
            self._begin(processes)
        while True:
            ready = wait([self._end, *processes])
            if self._end in ready:
                break
            for connection in ready:
                if not processes[connection].is_alive():
                    self._begin_anew(processes, connection)
            if all(process.is_up for process in processes.values()):
                self._are_settled.set()

    def _begin(self, processes: Dict[object, _Process]) -> None:
        try:
            process = self._make()
        except OSError as problem:  # the limit of files, processes or memory is reached
            raise RunsStopped(f"process {len(processes) + 1} of {self._count} that makes runs cannot be started: "
                              f"{problem.strerror or problem}") from None
        processes[process.listens] = process

    def _begin_anew(self, processes: Dict[object, _Process], connection: object) -> None:
        dead = processes.pop(connection)
        self._failed_starts = 0 if dead.is_up else self._failed_starts + 1
        dead.end()
        if self._failed_starts >= MOST_FAILED_STARTS:
            raise RunsStopped(f"processes that make runs cannot be started: {MOST_FAILED_STARTS} ended as they began")
        self._begin(processes)

    def wait_until_up(self) -> None:
        """@raise RunsStopped if the processes cannot be started"""
        self._are_settled.wait()
        if self._problem:
            raise RunsStopped(self._problem)

    def __enter__(self) -> "WorkerProcesses":
        self._keeper.start()
        return self

    def __exit__(self, _kind: object, error: Optional[BaseException], _trace: object) -> None:
        """@raise RunsStopped if processes could not be started, in place of errors caused by that"""
        self._ends.close()
        self._keeper.join()
        if self._problem and isinstance(error, Exception):
            raise RunsStopped(self._problem) from error

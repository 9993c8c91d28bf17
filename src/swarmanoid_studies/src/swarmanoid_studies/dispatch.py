"""Sends runs to workers and receives their results; each run has a result, also if workers die.

Short runs are sent in bundles of about half a second, to reduce the cost of sending. Runs that end their process have rows with that
failure, see makers.py. Dask gives the bundles of a dead worker to others. If several workers died of a bundle, each of its runs is
made alone."""

import itertools
import queue
import sys
import time
import uuid
from typing import Dict, Iterable, Iterator, List, Sequence, Tuple

from distributed import Client, Future, KilledWorker

from .contents_fields import OtherContents
from .makers import make_runs
from .mistakes import RunsStopped, hear_interrupts
from .progress import duration
from .runs import RunOutcome, RunRequest, lost

BUNDLE_S = 0.5
MOST_IN_BUNDLE = 50
AHEAD = 2  # bundles per process, so that processes do not wait for the next one
LOOK_S = 1.0       # interval between counts of workers [s]
SILENCE_S = 5.0    # time without workers before a message [s]
WAIT_S = 600.0     # time without workers before the program ends: a cluster may start them after the batch [s]
Numbered = Tuple[int, RunRequest]


class _Pace:
    """Chooses the number of runs per bundle. Starts with one."""

    def __init__(self) -> None:
        self._run_s = 0.0  # weighted mean time of the last runs [s]

    def note(self, outcomes: Sequence[RunOutcome]) -> None:
        for outcome in outcomes:
            self._run_s += 0.2 * (max(outcome.wall_s, 1e-4) - self._run_s) if self._run_s else max(outcome.wall_s, 1e-4)

    def bundle(self, waiting: int, processes: int) -> int:
        if not self._run_s:
            return 1
        even = -(-waiting // (AHEAD * processes))  # the last runs are distributed evenly
        return max(1, min(MOST_IN_BUNDLE, even, int(BUNDLE_S / self._run_s)))


class _Processes:
    """Counts the processes of workers: on a cluster workers may join and leave at any time."""

    def __init__(self, client: Client) -> None:
        self._client = client
        self._count = 1
        self._next_look = 0.0
        self._last_seen = time.monotonic()
        self._is_reported = False

    def count(self) -> int:
        """@raise RunsStopped if there were no workers for too long"""
        now = time.monotonic()
        if now >= self._next_look:
            self._count = sum(self._client.nthreads().values())
            self._next_look = now + LOOK_S
            if self._count:
                self._last_seen = now
            elif self._client.cluster is None:   # on this computer worker_processes restarts them
                self._report(now - self._last_seen)
        return max(1, self._count)

    def _report(self, idle_s: float) -> None:
        if idle_s >= WAIT_S:
            raise RunsStopped(f"the scheduler has had no workers for {duration(idle_s)}")
        if idle_s >= SILENCE_S and not self._is_reported:
            self._is_reported = True
            print(f"swarmanoid: the scheduler has no workers, waiting up to {duration(WAIT_S)} for `swarmanoid worker`", file=sys.stderr)


def _submit(client: Client, bundle: Sequence[Numbered]) -> Future:
    return client.submit(make_runs, [request for _, request in bundle], key=f"runs-{uuid.uuid4()}", pure=False)


def _result(future: Future) -> List[RunOutcome]:
    """@raise KilledWorker, RunsStopped"""
    try:
        return future.result()
    except (KilledWorker, RunsStopped):
        raise
    except OtherContents as others:
        raise RunsStopped(str(others)) from None
    except Exception as error:  # not a failed run, which returns: an error of Dask, or of an incomplete worker
        raise RunsStopped(f"the workers are lost: {type(error).__name__}: {error}") from error


class _Sent:
    """Bundles sent to workers, and finished ones."""

    def __init__(self, client: Client, processes: _Processes) -> None:
        self._client = client
        self._processes = processes
        self._bundles: Dict[Future, List[Numbered]] = {}
        self._finished: "queue.SimpleQueue[Future]" = queue.SimpleQueue()

    def __len__(self) -> int:
        return len(self._bundles)

    def send(self, bundle: List[Numbered]) -> None:
        future = _submit(self._client, bundle)
        self._bundles[future] = bundle
        future.add_done_callback(self._finished.put)

    def take(self) -> Tuple[Future, List[Numbered]]:
        """Waits for the next finished bundle. @raise RunsStopped, KeyboardInterrupt"""
        while True:
            hear_interrupts()
            try:
                future = self._finished.get(timeout=LOOK_S)
                return future, self._bundles.pop(future)
            except queue.Empty:
                self._processes.count()


def _alone(sent: _Sent, suspects: Sequence[Numbered]) -> Iterator[Tuple[int, RunOutcome]]:
    """Makes each run in a bundle of its own. @param sent without pending bundles"""
    for number, request in suspects:
        start_s = time.perf_counter()
        sent.send([(number, request)])
        future, _ = sent.take()
        try:
            outcome, = _result(future)
        except KilledWorker:
            reason = "the process that made the run ended in it, each time that it was tried"
            outcome = lost(reason)._replace(wall_s=time.perf_counter() - start_s)
        yield number, outcome


def outcomes(client: Client, requests: Iterable[Numbered], count: int) -> Iterator[Tuple[int, RunOutcome]]:
    """Makes all runs. @param requests consumed on demand @param count number of requests
    @return number of each request and its outcome, in the order of completion
    @raise RunsStopped if the scheduler is lost, or has no workers for too long"""
    waiting, left = iter(requests), count
    suspects: List[Numbered] = []
    pace, processes = _Pace(), _Processes(client)
    sent = _Sent(client, processes)

    def send() -> None:
        nonlocal left
        while left and len(sent) < AHEAD * processes.count():
            bundle = list(itertools.islice(waiting, pace.bundle(left, processes.count())))
            left -= len(bundle)
            sent.send(bundle)

    send()
    while len(sent):
        future, bundle = sent.take()
        try:
            results = _result(future)
        except KilledWorker:
            suspects += bundle
            results = []
        pace.note(results)
        send()  # before rows are written, so that workers stay busy
        yield from ((number, outcome) for (number, _), outcome in zip(bundle, results))
    yield from _alone(sent, suspects)

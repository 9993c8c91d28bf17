"""Sends runs to workers, and takes what comes back, whoever dies meanwhile.

Short runs go in bundles, so that sending costs little beside them; a bundle takes some half a second. Dask gives what a dead
worker had to others. A bundle that several workers died of is taken apart: each of its runs is made alone, and the one that
ends its process is told by name."""

import collections
import time
import uuid
from typing import Deque, Dict, Iterator, List, Sequence, Tuple

from distributed import Client, Future, KilledWorker, as_completed

from .contents import OtherContents
from .mistakes import RunsStopped, hear_interrupts
from .run_maker import make_runs
from .runs import RunOutcome, RunRequest, lost

BUNDLE_S = 0.5
MOST_IN_BUNDLE = 50
AHEAD = 2  # bundles a process, so that none waits for the next one
Numbered = Tuple[int, RunRequest]


class _Pace:
    """How many runs make a bundle. Starts with one."""

    def __init__(self) -> None:
        self._run_s = 0.0  # of the last runs, weighted

    def note(self, outcomes: Sequence[RunOutcome]) -> None:
        for outcome in outcomes:
            self._run_s += 0.2 * (max(outcome.wall_s, 1e-4) - self._run_s) if self._run_s else max(outcome.wall_s, 1e-4)

    def bundle(self, waiting: int, processes: int) -> int:
        if not self._run_s:
            return 1
        even = -(-waiting // (AHEAD * processes))  # the last bundles are shared out
        return max(1, min(MOST_IN_BUNDLE, even, int(BUNDLE_S / self._run_s)))


class _Processes:
    """How many there are: on a cluster they come and go."""

    def __init__(self, client: Client) -> None:
        self._client = client
        self._count = 1
        self._next_look = 0.0

    def count(self) -> int:
        if time.monotonic() >= self._next_look:
            self._count = max(1, sum(self._client.nthreads().values()))
            self._next_look = time.monotonic() + 1.0
        return self._count


def _submit(client: Client, bundle: Sequence[Numbered]) -> Future:
    return client.submit(make_runs, [request for _, request in bundle], key=f"runs-{uuid.uuid4()}", pure=False)


def _result(future: Future) -> List[RunOutcome]:
    """@raise KilledWorker, RunsStopped"""
    try:
        return future.result()
    except KilledWorker:
        raise
    except OtherContents as others:
        raise RunsStopped(str(others)) from None
    except Exception as error:  # runs that fail return: this is of Dask, or of a worker that lacks something
        raise RunsStopped(f"the workers are lost: {type(error).__name__}: {error}") from error


def _alone(client: Client, suspects: Sequence[Numbered]) -> Iterator[Tuple[int, RunOutcome]]:
    for number, request in suspects:
        try:
            outcome, = _result(_submit(client, [(number, request)]))
        except KilledWorker:
            outcome = lost("the process that made the run ended in it, each time that it was tried")
        yield number, outcome


def outcomes(client: Client, requests: Sequence[RunRequest]) -> Iterator[Tuple[int, RunOutcome]]:
    """Makes all runs. @return index of the request and its outcome, each once, in the order in which they are done
    @raise RunsStopped if the scheduler is lost"""
    waiting: Deque[Numbered] = collections.deque(enumerate(requests))
    sent: Dict[Future, List[Numbered]] = {}
    suspects: List[Numbered] = []
    pace, processes = _Pace(), _Processes(client)
    completed = as_completed()

    def send() -> None:
        while waiting and len(sent) < AHEAD * processes.count():
            size = pace.bundle(len(waiting), processes.count())
            bundle = [waiting.popleft() for _ in range(min(size, len(waiting)))]
            future = _submit(client, bundle)
            sent[future] = bundle
            completed.add(future)

    send()
    for future in completed:
        hear_interrupts()
        bundle = sent.pop(future)
        try:
            results = _result(future)
        except KilledWorker:
            suspects += bundle
            results = []
        pace.note(results)
        send()  # before the rows are written: workers go on
        yield from ((number, outcome) for (number, _), outcome in zip(bundle, results))
    yield from _alone(client, suspects)

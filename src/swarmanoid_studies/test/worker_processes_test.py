#!/usr/bin/python3
"""Processes that make runs, and those that cannot be started."""

import multiprocessing
import threading
import time
import unittest
from unittest import mock

import psutil
from swarmanoid_studies import worker_processes
from swarmanoid_studies.mistakes import RunsStopped
from swarmanoid_studies.workers import connected

PATIENCE_S = 60


def processes():
    return {child.pid for child in psutil.Process().children(recursive=True) if any("spawn_main" in word for word in child.cmdline())}


class WorkerProcessesTest(unittest.TestCase):
    def test_one_that_is_killed_is_started_again_and_all_end_with_the_context(self):
        with connected(2, None) as client:
            first = processes()
            self.assertEqual(len(first), 2)
            killed = min(first)
            psutil.Process(killed).kill()
            end = time.monotonic() + PATIENCE_S
            while len(processes() - {killed}) < 2 or len(client.nthreads()) < 2:
                self.assertLess(time.monotonic(), end, "it is not started again")
                time.sleep(0.02)
            self.assertEqual(client.gather(client.map(abs, (-3, 4))), [3, 4])
        self.assertEqual(processes(), set())

    def test_processes_that_end_as_they_begin_are_told(self):
        begun = []

        class Stillborn:
            is_up = False

            def __init__(self, *_):
                begun.append(self)
                self.listens, other = multiprocessing.Pipe(duplex=False)
                other.close()

            def is_alive(self):
                return False

            def end(self):
                self.listens.close()

        given_up = threading.Event()
        with mock.patch.object(worker_processes, "_Process", Stillborn), \
                worker_processes.WorkerProcesses(3, "tcp://127.0.0.1:1", None, given_up.set) as some:
            with self.assertRaises(RunsStopped) as caught:
                some.wait_until_up()
            self.assertTrue(given_up.wait(PATIENCE_S))
        self.assertEqual(str(caught.exception), "processes that make runs cannot be started: 10 ended as they began")
        self.assertLessEqual(len(begun), 3 + 12)  # each that ended once more, though several may end at the same time


if __name__ == "__main__":
    unittest.main()

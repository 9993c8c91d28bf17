#!/usr/bin/python3
"""Processes that make runs, and failures to start them."""

import errno
import multiprocessing
import os
import resource
import threading
import time
import unittest
from unittest import mock

import psutil
from swarmanoid_studies import worker_processes, workers
from swarmanoid_studies.mistakes import BadInput, RunsStopped
from swarmanoid_studies.workers import allow_files, connected

PATIENCE_S = 60


def processes():
    return {child.pid for child in psutil.Process().children(recursive=True) if any("spawn_main" in word for word in child.cmdline())}


def refused_from(number):
    """@return a fake process class, up at once, whose start fails from the given number on; lists of started and ended ones"""
    begun, ended = [], []

    class Process:
        is_up = True

        def __init__(self, *_):
            if len(begun) + 1 >= number:
                raise OSError(errno.EMFILE, os.strerror(errno.EMFILE))
            begun.append(self)
            self.listens, self.lives = multiprocessing.Pipe(duplex=False)
            self.lives.send(True)

        def is_alive(self):
            try:
                return self.listens.recv()
            except EOFError:
                return False

        def end(self):
            ended.append(self)

    return Process, begun, ended


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

    def test_a_low_limit_of_open_files_is_raised(self):
        limits = resource.getrlimit(resource.RLIMIT_NOFILE)
        self.addCleanup(resource.setrlimit, resource.RLIMIT_NOFILE, limits)
        resource.setrlimit(resource.RLIMIT_NOFILE, (len(os.listdir("/proc/self/fd")) + 20, limits[1]))
        allow_files(3)
        with connected(3, None) as client:
            self.assertEqual(client.gather(client.map(abs, (-3, 4))), [3, 4])

    def test_more_processes_than_the_limit_of_open_files_allows_are_refused(self):
        with mock.patch.object(resource, "getrlimit", return_value=(256, 400)), self.assertRaises(BadInput) as caught:
            allow_files(57)
        self.assertEqual(str(caught.exception), "found a limit of 400 open files (`ulimit -Hn`), allowed: at least 406 for 57 "
                         "processes that make runs")

    def test_without_a_number_there_are_as_many_as_the_limit_of_open_files_allows(self):
        with mock.patch.object(resource, "getrlimit", return_value=(60, 100)), mock.patch.object(resource, "setrlimit") as limited, \
                mock.patch.object(workers, "default_jobs", return_value=64):
            self.assertEqual(allow_files(None), 6)
        limited.assert_called_once_with(resource.RLIMIT_NOFILE, (100, 100))

    def test_processes_that_end_as_they_begin_are_reported(self):
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
        self.assertLessEqual(len(begun), 3 + 12)  # each ended process is restarted; several may end at the same time

    def test_one_that_the_system_refuses_is_reported_and_others_end(self):
        process, begun, ended = refused_from(3)
        given_up = threading.Event()
        with mock.patch.object(worker_processes, "_Process", process), self.assertRaises(RunsStopped) as caught, \
                worker_processes.WorkerProcesses(4, "tcp://127.0.0.1:1", None, given_up.set) as some:
            self.assertTrue(given_up.wait(PATIENCE_S))
            some.wait_until_up()
        self.assertEqual(str(caught.exception), "process 3 of 4 that makes runs cannot be started: Too many open files")
        self.assertEqual((len(begun), ended), (2, begun))

    def test_one_that_cannot_be_started_again_is_reported_instead_of_what_follows(self):
        process, begun, ended = refused_from(3)
        given_up = threading.Event()
        with mock.patch.object(worker_processes, "_Process", process), self.assertRaises(RunsStopped) as caught, \
                worker_processes.WorkerProcesses(2, "tcp://127.0.0.1:1", None, given_up.set) as some:
            some.wait_until_up()
            begun[0].lives.close()
            self.assertTrue(given_up.wait(PATIENCE_S))
            raise RunsStopped("the workers are lost: CancelledError: runs")
        self.assertEqual(str(caught.exception), "process 2 of 2 that makes runs cannot be started: Too many open files")
        self.assertEqual(ended, begun)


if __name__ == "__main__":
    unittest.main()

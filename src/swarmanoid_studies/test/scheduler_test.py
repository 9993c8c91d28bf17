#!/usr/bin/python3
"""A batch and its scheduler: workers that join late, or never."""

import json
import os
import signal
import socket
import subprocess
import time
import unittest
from unittest import mock

from commands import FINISHED, PATIENCE_S, CommandsTest
from distributed import Client, KilledWorker
from swarmanoid_studies import dispatch
from swarmanoid_studies.mistakes import RunsStopped
from swarmanoid_studies.runs import RunRequest

WAITING = "swarmanoid: the scheduler has no workers, waiting up to 10 min 0 s for `swarmanoid worker`\n"


class SchedulerTest(CommandsTest):
    def setUp(self):
        super().setUp()
        with socket.socket() as free:
            free.bind(("127.0.0.1", 0))
            port = free.getsockname()[1]
        self.address = f"tcp://127.0.0.1:{port}"
        scheduler = subprocess.Popen(["dask-scheduler", "--host", "127.0.0.1", "--port", str(port), "--no-dashboard"], cwd=self.folder,
                                     stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, start_new_session=True)
        self.addCleanup(self.end, scheduler)
        end = time.monotonic() + PATIENCE_S
        while True:
            try:
                socket.create_connection(("127.0.0.1", port)).close()
                return
            except OSError:
                self.assertLess(time.monotonic(), end, "the scheduler does not begin")
                time.sleep(0.1)

    def end(self, process):
        os.killpg(process.pid, signal.SIGKILL)
        process.wait()

    def test_a_batch_says_that_it_waits_and_goes_on_when_a_worker_comes(self):
        program = self.start("batch", "phototaxis", "--seeds", "1..4", "--ticks", 20, "--scheduler", self.address, "--quiet", "--no-report")
        self.assertEqual(program.stderr.readline(), WAITING)
        worker = subprocess.Popen(["swarmanoid", "worker", self.address, "--jobs", "1"], cwd=self.folder, stdout=subprocess.DEVNULL,
                                  stderr=subprocess.DEVNULL, start_new_session=True)
        self.addCleanup(self.end, worker)
        output, errors = program.communicate(timeout=PATIENCE_S)
        self.assertEqual((program.returncode, errors), (FINISHED, ""))
        self.assertEqual(json.loads(output)["made"], 4)

    def test_it_does_not_wait_for_ever(self):
        with Client(self.address) as client, mock.patch.object(dispatch, "SILENCE_S", 60.0), mock.patch.object(dispatch, "WAIT_S", 2.0), \
                self.assertRaises(RunsStopped) as caught:
            list(dispatch.outcomes(client, [(0, RunRequest("phototaxis", (), 1))], 1))
        self.assertRegex(str(caught.exception), "^the scheduler has had no workers for [2-4] s$")

    def test_nor_for_a_run_that_is_made_alone(self):
        with Client(self.address) as client, mock.patch.object(dispatch, "SILENCE_S", 60.0), mock.patch.object(dispatch, "WAIT_S", 2.0), \
                self.assertRaises(RunsStopped) as caught:
            sent = dispatch._Sent(client, dispatch._Processes(client))
            list(dispatch._alone(sent, [(0, RunRequest("phototaxis", (), 1))]))
        self.assertRegex(str(caught.exception), "^the scheduler has had no workers for [2-4] s$")

    def test_a_run_that_ends_its_workers_has_a_row_with_its_time(self):
        future = mock.Mock()
        future.result.side_effect = KilledWorker("runs", None, 3)
        sent = mock.Mock()
        sent.take.side_effect = lambda: time.sleep(0.2) or (future, [])
        (number, outcome), = dispatch._alone(sent, [(7, RunRequest("phototaxis", (), 1))])
        self.assertEqual((number, outcome.failure), (7, "the process that made the run ended in it, each time that it was tried"))
        self.assertGreaterEqual(outcome.wall_s, 0.2)


if __name__ == "__main__":
    unittest.main()

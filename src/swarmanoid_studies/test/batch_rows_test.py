#!/usr/bin/python3
"""The count of a batch equals the rows of its file, whenever it is interrupted."""

import os
import pathlib
import signal
import tempfile
import unittest
from unittest import mock

from swarmanoid_studies import batch_command, mistakes
from swarmanoid_studies.grid import Requests, parse_grid
from swarmanoid_studies.identity_fields import Identity
from swarmanoid_studies.progress import Progress
from swarmanoid_studies.results_file import Columns, ResultsFile
from swarmanoid_studies.runs import RunOutcome

REQUESTS = Requests(parse_grid("1..5", []), "gap", {})
OUTCOME = RunOutcome({}, None, 7, 0.25, "00ff", "", True)


class InterruptedFile(ResultsFile):
    """Sends Ctrl-C as soon as the third row is in the file."""

    def append(self, request, outcome):
        super().append(request, outcome)
        if request.seed == 3:
            os.kill(os.getpid(), signal.SIGINT)


class BatchRowsTest(unittest.TestCase):
    def test_a_row_that_an_interrupt_finds_written_is_counted(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        path = pathlib.Path(folder.name) / "runs.csv"
        results = InterruptedFile(str(path), Identity("gap", "0.1.0+abc", "glibc 2.36, any x86-64", "12345678"), Columns((), ()))
        self.addCleanup(results.close)
        results.create(is_replaced=False)
        made = []

        def main():
            done = ((number, OUTCOME) for number in range(len(REQUESTS)))
            with mock.patch("swarmanoid_studies.dispatch.outcomes", lambda client, requests, count: done):
                made.append(batch_command.make_rows(results, REQUESTS, bytearray(5), None, Progress("gap", 5, 0, True)))
            return mistakes.FINISHED

        self.assertEqual(mistakes.call(main), mistakes.FINISHED)
        self.assertEqual(made, [(batch_command.Counts(made=3), True)])
        self.assertEqual(len(path.read_text().splitlines()), 1 + 3)


if __name__ == "__main__":
    unittest.main()

#!/usr/bin/python3
"""The CSV file of a batch: complete rows, and only rows of that batch."""

import csv
import os
import pathlib
import resource
import tempfile
import unittest

from swarmanoid_studies.grid import Axis, Grid, Requests
from swarmanoid_studies.identity_fields import Identity
from swarmanoid_studies.mistakes import BadInput, RunsStopped
from swarmanoid_studies.results_file import Columns, ResultsFile
from swarmanoid_studies.runs import RunOutcome, RunRequest, lost
from swarmanoid_studies.seeds import parse_seeds

IDENTITY = Identity("gap", "0.1.0+abc", "glibc 2.36, any x86-64", "12345678")
COLUMNS = Columns(("a.b",), ("m.x", "m.done"))


def request(seed, value="1, 2"):
    return RunRequest("gap", (("framework.maxclock", "7"), ("a.b", value)), seed)


def runs(seeds="1..5"):
    return Requests(Grid((Axis("a.b", ("1, 2",)),), parse_seeds(seeds)), "gap", {"framework.maxclock": "7"})


def outcome(number):
    return RunOutcome({"m.x": number, "m.done": True}, None, 7, 0.25, "00ff00ff00ff00ff", "", True)


class ResultsFileTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = pathlib.Path(folder.name) / "runs.csv"
        self.runs = runs()

    def open(self, identity=IDENTITY, columns=COLUMNS):
        results = ResultsFile(str(self.path), identity, columns)
        self.addCleanup(results.close)
        return results

    def written(self, *seeds):
        results = self.open()
        results.create(is_replaced=True)
        for seed in seeds:
            results.append(request(seed), outcome(0.1 * seed))
        results.close()
        return self.path.read_text()

    def refused(self, message, **options):
        before = self.path.read_bytes()
        with self.assertRaises(BadInput) as caught:
            self.open(**options).resume(self.runs)
        self.assertEqual(str(caught.exception), f"{self.path}{message}")
        self.assertEqual(self.path.read_bytes(), before)

    def test_numbers_keep_their_digits_and_failures_their_line(self):
        self.written(3)
        results = self.open()
        results.resume(self.runs)
        results.append(request(4), lost('said "no",\nand  died')._replace(metrics={"m.x": "two\nlines"}))
        with open(self.path, newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual([row["seed"] for row in rows], ["3", "4"])
        self.assertEqual(float(rows[0]["m.x"]), 0.1 * 3)
        self.assertEqual((rows[0]["m.done"], rows[0]["success"], rows[0]["a.b"]), ("true", "", "1, 2"))
        self.assertEqual((rows[1]["failure"], rows[1]["m.x"]), ('said "no", and died', "two lines"))

    def test_a_long_text_is_read_again(self):
        self.written(1)
        results = self.open()
        results.resume(self.runs)
        results.append(request(2), outcome("x" * 200_000))
        results.close()
        self.assertEqual(list(self.open().resume(self.runs)), [1, 1, 0, 0, 0])

    def test_wherever_it_was_cut_off_whole_rows_are_kept(self):
        text = self.written(1, 2, 3)
        rows = text.splitlines(keepends=True)
        for size in range(len(text) + 1):
            self.path.write_text(text[:size])
            results = self.open()
            done = results.resume(self.runs)
            for seed in range(1, 4):
                if not done[seed - 1]:
                    results.append(request(seed), outcome(0.1 * seed))
            results.close()
            self.assertEqual(self.path.read_text(), text, size)
        self.assertEqual(len(rows), 4)

    def test_another_batch_is_refused(self):
        text = self.written(1, 2)
        self.refused(":2: found a run of another version ('0.1.0+abc'), allowed: '0.1.0+abd'",
                     identity=IDENTITY._replace(version="0.1.0+abd"))
        self.refused(":2: found a run of another fingerprint ('12345678'), allowed: '87654321'",
                     identity=IDENTITY._replace(fingerprint="87654321"))
        self.refused(":1: found the columns of another batch, allowed: experiment,version,math_library,fingerprint,a.c,seed,"
                     "success,ticks,wall_s,state_hash,failure,overrides,m.x", columns=Columns(("a.c",), ("m.x",)))
        self.runs = runs("1,3..5")
        self.refused(":3: found the run a.b=1, 2, seed=2, allowed: runs of this batch")
        self.path.write_text(text + text.splitlines()[1] + "\n")
        self.runs = runs()
        self.refused(":4: found a run a second time, allowed: once")
        self.path.write_text("x,y\n1,2\n")
        self.refused(":1: found other columns, allowed: those of a CSV file that `swarmanoid batch` has written")

    def test_a_file_is_not_replaced_unless_asked(self):
        self.written(1)
        with self.assertRaisesRegex(BadInput, "found a file, allowed: another name, --resume to continue it, or --force"):
            self.open().create(is_replaced=False)

    def test_two_programs_do_not_write_one_file(self):
        self.written(1)
        self.open().resume(self.runs)
        self.refused(": another program is writing it")

    def test_where_the_disk_is_full_whole_rows_are_kept_and_the_file_is_named(self):
        rows = self.written(1, 2).splitlines(keepends=True)
        results = self.open()
        results.resume(self.runs)
        limits = resource.getrlimit(resource.RLIMIT_FSIZE)
        self.addCleanup(resource.setrlimit, resource.RLIMIT_FSIZE, limits)
        for room in (0, 1, 20):
            resource.setrlimit(resource.RLIMIT_FSIZE, (self.path.stat().st_size + room, limits[1]))
            with self.assertRaises(RunsStopped) as caught:
                results.append(request(3), outcome(0.3))
            resource.setrlimit(resource.RLIMIT_FSIZE, limits)
            self.assertEqual(str(caught.exception), f"{self.path}: cannot be written: File too large")
            self.assertEqual(self.path.read_text(), "".join(rows))

    def test_what_is_no_regular_file_is_refused(self):
        os.mkfifo(self.path)
        for action in (lambda: self.open().create(is_replaced=True), lambda: self.open().resume(self.runs)):
            with self.assertRaises(BadInput) as caught:
                action()
            self.assertRegex(str(caught.exception), f"^{self.path}: cannot be (written|read): it is no regular file$")

    def test_metrics_without_a_column_are_reported(self):
        results = self.open()
        results.create(is_replaced=True)
        results.append(request(1), outcome(1.0)._replace(metrics={"m.x": 1.0, "m.new": 2.0}))
        self.assertIn(",metrics without a column: m.new,", self.path.read_text())


if __name__ == "__main__":
    unittest.main()

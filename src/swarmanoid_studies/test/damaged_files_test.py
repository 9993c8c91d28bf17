#!/usr/bin/python3
"""Thousands of randomly damaged files: each is read, or rejected in one line with its name, and never with a traceback."""

import contextlib
import io
import json
import os
import pathlib
import random
import re
import tempfile
import time
import unittest
from unittest import mock

from swarmanoid_studies import checkpoint, report, report_command
from swarmanoid_studies.identity_fields import Identity
from swarmanoid_studies.input_file import NUMBER
from swarmanoid_studies.mistakes import BAD_INPUT, FINISHED, BadInput, call
from swarmanoid_studies.results_file import Columns, line_of
from swarmanoid_studies.study_file import read_study
from study_file_test import STUDY

CASES = 2000        # of each format
DRAWN_OF = 20       # only one in 20 reports is drawn, since that takes 0.2 s
CELLS = (b"", b"1e308", b"-1e308", b"1e-320", b"nan", b"inf", b"-inf", b"1e999", b"9" * 400, b"$a$b_c^", b"x" * 5000, b"1_0", b"0x10",
         b"\xff\xfe", b"\x00", b'"', b"true", b"<b>&amp;", b"-1", b"007", b" 1", "\u0661\u6c49".encode(), b"[" * 3000, b"{}", b"null")
IDENTITY = Identity("gap", "0.1.0+abc", "glibc 2.36, any x86-64", "12345678")
MADE_OF = {**IDENTITY._asdict(), "seeds": [1, 2]}


def results():
    columns = Columns(("a.b", "a.c"), ('"l.comma,', "m.done"))
    rows = [line_of(columns.names())]
    for seed in range(1, 5):
        for value in ("1", "2, 3"):
            rows.append(line_of([*IDENTITY, value, "x", seed, None, 7, 0.25, "00ff00ff00ff00ff", "", "[]", 0.1 * seed, True]))
    return b"".join(rows)


def generations():
    return [checkpoint.Generation([[0.5, 0.25]] * 4, [[1.5], [None], [2.5], [-0.0]], 1, ["genotype 0, seed 1: died"])] * 3


class Damage:
    def __init__(self, seed):
        self._chance = random.Random(seed)

    def of(self, content, separators):
        """@param separators of lines and cells"""
        for _ in range(self._chance.choice((1, 1, 2, 5))):
            content = self._chance.choice((self._bytes, self._cut, self._cells, self._cells, self._lines))(content, separators)
        return content

    def _bytes(self, content, _):
        changed = bytearray(content)
        for _ in range(min(len(changed), self._chance.randint(1, 3))):
            changed[self._chance.randrange(len(changed))] = self._chance.randrange(256)
        return bytes(changed)

    def _cut(self, content, _):
        first, last = sorted(self._chance.randrange(len(content) + 1) for _ in range(2))
        return content[:first] + content[min(last, first + self._chance.choice((1, 30, 10000))):]

    def _lines(self, content, separators):
        lines = content.split(separators[0])
        lines.insert(self._chance.randrange(len(lines)), self._chance.choice(lines))
        return separators[0].join(lines)

    def _cells(self, content, separators):
        lines = content.split(separators[0])
        line = self._chance.randrange(len(lines))
        cells = lines[line].split(separators[1])
        cell = self._chance.randrange(len(cells))
        cells[cell:cell + self._chance.randrange(2)] = [self._chance.choice((*CELLS, *cells))]
        lines[line] = separators[1].join(cells)
        return separators[0].join(lines)


class DamagedFilesTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = pathlib.Path(folder.name) / "file"

    def assert_one_line(self, message):
        self.assertRegex(message, rf"\A{re.escape(str(self.path))}(:[0-9]+)?: [^\n]+\Z")
        self.assertLess(len(message), 2000)

    def refusals(self, content, separators, read):
        """@return number of rejected files"""
        damage, count = Damage(7), 0
        for case in range(CASES):
            damaged = damage.of(content, separators)
            self.path.write_bytes(damaged)
            with self.subTest(case):
                try:
                    read()
                except BadInput as mistake:
                    self.assert_one_line(str(mistake))
                    count += 1
        return count

    def test_reports(self):
        damage, codes, case = Damage(7), [], 0
        all_pictures = report.all_pictures

        def drawn(found, title):
            return all_pictures(found, title) if case % DRAWN_OF == 0 else b""

        for case in range(CASES):
            damaged = damage.of(results(), (b"\n", b","))
            self.path.write_bytes(damaged)
            errors = io.StringIO()
            arguments = ["report", str(self.path), "--out", str(self.path.parent / ("a.png" if case % 2 == 0 else "a.html"))]
            with self.subTest(case), contextlib.redirect_stderr(errors), contextlib.redirect_stdout(io.StringIO()), \
                    mock.patch("sys.argv", arguments), mock.patch.object(report, "all_pictures", drawn), \
                    mock.patch.object(report, "picture", lambda *_: b""):
                codes.append(call(report_command._main))
                if codes[-1] == FINISHED:
                    self.assertEqual(errors.getvalue(), "")
                else:
                    self.assert_one_line(errors.getvalue().rstrip("\n").replace("swarmanoid: ", "", 1))
        self.assertEqual(set(codes), {FINISHED, BAD_INPUT})
        self.assertGreater(codes.count(FINISHED), CASES // 20)
        self.assertGreater(codes.count(BAD_INPUT), CASES // 4)

    def test_checkpoints(self):
        checkpoint.write_checkpoint(str(self.path), MADE_OF, generations())

        def read():
            self.assertEqual(checkpoint.read_checkpoint(str(self.path), MADE_OF), generations(), "read, but not what was written")

        read()
        self.assertGreater(self.refusals(self.path.read_bytes(), (b"\n", b","), read), CASES // 2)

    def test_checkpoints_are_refused_by_name(self):
        checkpoint.write_checkpoint(str(self.path), MADE_OF, generations())
        text = self.path.read_text()
        whole = "allowed: a checkpoint as `swarmanoid evolve` has written it"
        for damaged, message in ((text.replace("2.5", "2.6"), f": is damaged: its content and its digest differ, {whole}"),
                                 ("[" * 100000, f": is damaged: its content and its digest differ, {whole}"),
                                 (text.replace('"format": 2', '"format": 1'), ": format: found 1, allowed: 2, as now"),
                                 ("7", f": is damaged: its content and its digest differ, {whole}"),
                                 (text.replace('"seeds"', "seeds"), f":7: Expecting property name enclosed in double quotes, {whole}")):
            self.path.write_text(damaged)
            with self.assertRaises(BadInput) as caught:
                checkpoint.read_checkpoint(str(self.path), MADE_OF)
            self.assertEqual(str(caught.exception), f"{self.path}{message}")
        self.path.write_text(text)
        with self.assertRaises(BadInput) as caught:
            checkpoint.read_checkpoint(str(self.path), {**MADE_OF, "seeds": [1, 3]})
        self.assertEqual(str(caught.exception), f"{self.path}: seeds: found [1, 2], allowed: [1, 3], as now")
        self.assertEqual(json.loads(text)["format"], 2)

    def test_studies(self):
        self.assertGreater(self.refusals(STUDY.encode(), (b"\n", b'"'), lambda: read_study(str(self.path))), CASES // 2)

    def test_numbers_are_recognised_in_linear_time(self):
        for text in ("3", "-0.5", "+.5", "2.", "1e+22", "1.5E-7", "007"):
            self.assertIsNotNone(NUMBER.fullmatch(text), text)
        start_s = time.process_time()
        for text in ("", ".", "1.2.3", "1.e", "e5", "1_000", "nan", "inf", "9" * 100_000 + "x"):
            self.assertIsNone(NUMBER.fullmatch(text), text[:10])
        self.assertLess(time.process_time() - start_s, 2.0)

    def test_what_is_no_regular_file_is_not_waited_for(self):
        os.mkfifo(self.path)
        for read in (lambda: read_study(str(self.path)), lambda: checkpoint.read_checkpoint(str(self.path), MADE_OF),
                     lambda: report.write_report(str(self.path), "a.png")):
            with self.assertRaises(BadInput) as caught:
                read()
            self.assertEqual(str(caught.exception), f"{self.path}: cannot be read: it is no regular file")


if __name__ == "__main__":
    unittest.main()

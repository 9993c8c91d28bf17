"""The CSV file of a batch: one row per run, written after the run.

A row is written by one system call, so the file has whole lines even if the program is killed; a row truncated by a full disk is
removed when the batch is continued. Columns: the identity of the runs (identity.py), the paths of --set, `seed`, the outcome of the
run, its metrics."""

import csv
import io
import json
import os
import stat
from typing import Dict, NoReturn, Sequence

from .atomic_file import lock, unwritable
from .grid import Requests
from .identity_fields import Identity
from .input_file import open_file, shown
from .mistakes import BadInput
from .results_columns import Columns
from .results_rows import RowReader
from .runs import Metric, RunOutcome, RunRequest, one_line


def text_of(value: object) -> str:
    """Text of a cell: numbers with all digits, and strings without line breaks."""
    if value is None:
        return ""
    if isinstance(value, bool):
        return "true" if value else "false"
    text = repr(value) if isinstance(value, float) else str(value)
    return text if text.isprintable() else one_line(text)


def line_of(values: Sequence[object]) -> bytes:
    """A line of a CSV file."""
    text = io.StringIO()
    csv.writer(text, lineterminator="\n").writerow([text_of(value) for value in values])
    return text.getvalue().encode(errors="backslashreplace")


def overrides_text(request: RunRequest) -> str:
    """All overrides of a run, including those of the whole batch. With the seed they reproduce the run."""
    return json.dumps([f"{path}={value}" for path, value in request.overrides])


class ResultsFile:
    """Open for appending, by one program at a time."""

    def __init__(self, path: str, identity: Identity, columns: Columns) -> None:
        self._path = path
        self._identity = identity
        self._columns = columns
        self._file = -1

    def refuse_existing(self) -> None:
        """Early check, before any run. @raise BadInput if the file exists"""
        if os.path.lexists(self._path):
            raise self._exists()

    def create(self, is_replaced: bool) -> None:
        """@param is_replaced whether an existing file is replaced @raise BadInput, RunsStopped"""
        try:
            self._file = os.open(self._path, os.O_RDWR | os.O_CREAT | os.O_APPEND | (0 if is_replaced else os.O_EXCL), 0o666)
        except FileExistsError:
            raise self._exists() from None
        except OSError as error:
            raise BadInput(f"{self._path}: cannot be written: {error.strerror}") from None
        if not stat.S_ISREG(os.fstat(self._file).st_mode):
            self.close()
            raise BadInput(f"{self._path}: cannot be written: it is no regular file")
        self._lock()
        os.ftruncate(self._file, 0)
        self._write(line_of(self._columns.names()))

    def resume(self, wanted: Requests) -> bytearray:
        """Continues a file. @param wanted runs of the batch
        @return by number of the run, 1 if it is in the file @raise BadInput if the file is of another batch"""
        try:
            self._file = os.open(self._path, os.O_RDWR | os.O_APPEND)
        except OSError as error:
            raise BadInput(f"{self._path}: cannot be continued: {error.strerror}") from None
        self._lock()
        try:
            done = self._read(wanted)
        except BadInput:
            self.close()
            raise
        if not os.fstat(self._file).st_size:
            self._write(line_of(self._columns.names()))
        return done

    def append(self, request: RunRequest, outcome: RunOutcome) -> None:
        """@raise RunsStopped"""
        values: Dict[str, Metric] = outcome.metrics
        unknown = sorted(set(values) - set(self._columns.metrics))
        if unknown:  # overrides have added a rule
            outcome = outcome._replace(failure=f"{outcome.failure} metrics without a column: {', '.join(unknown)}".strip())
        overrides = dict(request.overrides)
        row = [*self._identity, *(overrides[path] for path in self._columns.paths), request.seed, outcome.success, outcome.ticks,
               outcome.wall_s, outcome.state_hash, outcome.failure, overrides_text(request),
               *(values.get(name) for name in self._columns.metrics)]
        self._write(line_of(row))

    def close(self) -> None:
        if self._file >= 0:
            os.close(self._file)
            self._file = -1

    def _exists(self) -> BadInput:
        return BadInput(f"{self._path}: found a file, allowed: another name, --resume to continue it, or --force to replace it")

    def _lock(self) -> None:
        try:
            lock(self._file, self._path)
        except BaseException:
            self.close()
            raise

    def _write(self, line: bytes) -> None:
        """@raise RunsStopped"""
        written = 0
        try:
            while written < len(line):   # after a partial write, the second call raises the error
                written += os.write(self._file, line[written:])
        except OSError as error:
            os.ftruncate(self._file, os.fstat(self._file).st_size - written)   # removes the incomplete row
            raise unwritable(self._path, error) from None

    def _read(self, wanted: Requests) -> bytearray:
        done = bytearray(len(wanted))
        with open_file(self._path) as file:
            reader = RowReader(file, self._path)
            if not reader.is_empty and reader.columns != self._columns:
                raise BadInput(f"{self._path}:1: found the columns of another batch, allowed: {','.join(self._columns.names())}")
            for line, row in reader.rows() if not reader.is_empty else ():
                number = self._checked(line, row, wanted)
                if done[number]:
                    self._refuse(line, "found a run a second time, allowed: once")
                done[number] = 1
        os.ftruncate(self._file, reader.whole_bytes)
        return done

    def _checked(self, line: int, row: Sequence[str], wanted: Requests) -> int:
        """@return the number of the row's run"""
        for name, found, own in zip(Identity._fields, row, self._identity):
            if found != text_of(own):
                self._refuse(line, f"found a run of another {name} ('{shown(found)}'), allowed: '{own}'")
        *values, seed = row[len(Identity._fields):len(Identity._fields) + len(self._columns.paths) + 1]
        number = wanted.number(values, seed)
        if number is None:
            names = ", ".join(f"{name}={shown(value)}" for name, value in zip([*self._columns.paths, "seed"], [*values, seed]))
            self._refuse(line, f"found the run {names}, allowed: runs of this batch")
        return number

    def _refuse(self, line: int, problem: str) -> NoReturn:
        raise BadInput(f"{self._path}:{line}: {problem}")

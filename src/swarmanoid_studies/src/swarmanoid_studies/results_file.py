"""The CSV file of a batch: one row a run, written when the run is done.

A row is one call of the system, so the file has whole lines whenever the program dies; what a full disk has cut off is taken away
when it is continued. Columns: the identity of the runs (identity.py), the paths of --set, `seed`, what came of the run, its
metrics."""

import csv
import io
import json
import os
from typing import Dict, Sequence, Set, Tuple

from .atomic_file import lock
from .identity_fields import Identity
from .mistakes import BadInput
from .results_columns import Columns, columns_of
from .runs import Metric, RunOutcome, RunRequest


def text_of(value: object) -> str:
    """Numbers keep all their digits."""
    if value is None:
        return ""
    if isinstance(value, bool):
        return "true" if value else "false"
    return repr(value) if isinstance(value, float) else str(value)


def line_of(values: Sequence[object]) -> bytes:
    """Of a CSV file."""
    text = io.StringIO()
    csv.writer(text, lineterminator="\n").writerow([text_of(value) for value in values])
    return text.getvalue().encode()


def overrides_text(request: RunRequest) -> str:
    """All of them, also those that all runs of the batch share: with the seed what makes the run again."""
    return json.dumps([f"{path}={value}" for path, value in request.overrides])


class ResultsFile:
    """Open for appending, by one program at a time."""

    def __init__(self, path: str, identity: Identity, columns: Columns) -> None:
        self._path = path
        self._identity = identity
        self._columns = columns
        self._file = -1

    def refuse_existing(self) -> None:
        """Asked early, before anything is made. @raise BadInput"""
        if os.path.lexists(self._path):
            raise self._exists()

    def create(self, is_replaced: bool) -> None:
        """@param is_replaced a file that is there @raise BadInput, OSError"""
        try:
            self._file = os.open(self._path, os.O_RDWR | os.O_CREAT | os.O_APPEND | (0 if is_replaced else os.O_EXCL), 0o666)
        except FileExistsError:
            raise self._exists() from None
        except OSError as error:
            raise BadInput(f"{self._path}: cannot be written: {error.strerror}") from None
        self._lock()
        os.ftruncate(self._file, 0)
        self._write(line_of(self._columns.names()))

    def resume(self, wanted: Set[Tuple[str, ...]]) -> Set[Tuple[str, ...]]:
        """Continues a file. @param wanted keys of the runs of the batch, @see key_of
        @return keys of those that are in the file @raise BadInput if it is the file of another batch"""
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
        """@raise OSError"""
        values: Dict[str, Metric] = outcome.metrics
        unknown = sorted(set(values) - set(self._columns.metrics))
        if unknown:  # overrides have brought another rule in
            outcome = outcome._replace(failure=f"{outcome.failure} metrics without a column: {', '.join(unknown)}".strip())
        row = [*self._identity, *self.key_of(request), outcome.success, outcome.ticks, outcome.wall_s, outcome.state_hash,
               outcome.failure, overrides_text(request), *(values.get(name) for name in self._columns.metrics)]
        self._write(line_of(row))

    def key_of(self, request: RunRequest) -> Tuple[str, ...]:
        """What tells the run from others of the file."""
        values = dict(request.overrides)
        return (*(values[path] for path in self._columns.paths), str(request.seed))

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
        written = os.write(self._file, line)
        if written != len(line):  # the disk is full: the beginning of a row is worth nothing
            os.ftruncate(self._file, os.fstat(self._file).st_size - written)
            raise OSError(f"{self._path}: cannot be written: no space left")

    def _read(self, wanted: Set[Tuple[str, ...]]) -> Set[Tuple[str, ...]]:
        with open(self._path, "rb") as file:
            content = file.read()
        whole = content.rfind(b"\n") + 1
        os.ftruncate(self._file, whole)
        rows = list(csv.reader(io.StringIO(content[:whole].decode(errors="replace"))))
        if not rows:
            return set()
        if rows[0] != self._columns.names():
            columns_of(rows[0], self._path)
            raise BadInput(f"{self._path}:1: found the columns of another batch, allowed: {','.join(self._columns.names())}")
        done: Set[Tuple[str, ...]] = set()
        for line, row in enumerate(rows[1:], 2):  # rows have no line breaks in them
            done.add(self._checked(line, row, wanted, done))
        return done

    def _checked(self, line: int, row: Sequence[str], wanted: Set[Tuple[str, ...]], done: Set[Tuple[str, ...]]) -> Tuple[str, ...]:
        where = f"{self._path}:{line}"
        if len(row) != len(self._columns.names()):
            raise BadInput(f"{where}: found {len(row)} values, allowed: {len(self._columns.names())}")
        for name, found, own in zip(Identity._fields, row, self._identity):
            if found != own:
                raise BadInput(f"{where}: found a run of another {name} ('{found}'), allowed: '{own}'")
        key = tuple(row[len(Identity._fields):len(Identity._fields) + len(self._columns.paths) + 1])
        if key not in wanted:
            names = ", ".join(f"{name}={value}" for name, value in zip([*self._columns.paths, "seed"], key))
            raise BadInput(f"{where}: found the run {names}, allowed: runs of this batch")
        if key in done:
            raise BadInput(f"{where}: found a run a second time, allowed: once")
        return key

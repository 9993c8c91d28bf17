"""Reads a batch's CSV file strictly and row by row. A row is a line, and errors are reported with their line."""

import csv
import re
from typing import BinaryIO, Iterator, List, NoReturn, Optional, Tuple

from .input_file import NUMBER, shown
from .mistakes import BadInput
from .results_columns import Columns, columns_of
from .seeds import LARGEST_SEED

MOST_LINE = 1 << 20   # bytes of a line
csv.field_size_limit(MOST_LINE)   # a metric may be a long string
DIGITS = re.compile(r"0|[1-9][0-9]{0,19}")
HASH = re.compile(r"([0-9a-f]{16})?")


class RowReader:
    """Reads a file from its beginning."""

    def __init__(self, file: BinaryIO, path: str) -> None:
        """@raise BadInput if the file is not of a batch"""
        self._lines = file
        self._path = path
        self._line = 0
        self.whole_bytes = 0   # up to the end of the last complete row
        header = self._next()
        self.is_empty = header is None
        self.columns = Columns((), ()) if header is None else columns_of(header, path)

    def rows(self) -> Iterator[Tuple[int, List[str]]]:
        """Line number and cells of each complete row. @raise BadInput"""
        names = self.columns.names()
        seed = names.index("seed")
        while (row := self._next()) is not None:
            if len(row) != len(names):
                self._refuse(f"found {len(row)} values, allowed: {len(names)}")
            self._check(row[seed:seed + 5])
            yield self._line, row

    def _next(self) -> Optional[List[str]]:
        """The next row; None at the end, or at an incomplete row. @raise BadInput"""
        line = self._lines.readline(MOST_LINE)
        self._line += 1
        if not line.endswith(b"\n"):
            if len(line) == MOST_LINE:
                self._refuse(f"found a line of more than {MOST_LINE} bytes, allowed: rows as `swarmanoid batch` writes them")
            return None
        self.whole_bytes += len(line)
        try:
            row, = csv.reader([line.decode()], strict=True)
            return row
        except UnicodeDecodeError:
            self._refuse("found bytes that are no UTF-8, allowed: rows as `swarmanoid batch` writes them")
        except (csv.Error, ValueError):
            self._refuse(f"found '{shown(line.decode().strip())}', allowed: values separated by commas, quoted where they need it")

    def _check(self, cells: List[str]) -> None:
        seed, success, ticks, wall, state = cells
        if not DIGITS.fullmatch(seed) or int(seed) > LARGEST_SEED:
            self._refuse(f"seed: found '{shown(seed)}', allowed: a whole number from 0 to {LARGEST_SEED}")
        if success not in ("", "true", "false"):
            self._refuse(f"success: found '{shown(success)}', allowed: true, false, or nothing")
        if not DIGITS.fullmatch(ticks):
            self._refuse(f"ticks: found '{shown(ticks)}', allowed: a whole number")
        if not NUMBER.fullmatch(wall) or float(wall) < 0 or float(wall) == float("inf"):
            self._refuse(f"wall_s: found '{shown(wall)}', allowed: a number from 0 on")
        if not HASH.fullmatch(state):
            self._refuse(f"state_hash: found '{shown(state)}', allowed: 16 hexadecimal digits, or nothing")

    def _refuse(self, problem: str) -> NoReturn:
        raise BadInput(f"{self._path}:{self._line}: {problem}")

"""Seeds of a batch or a study: numbers and ranges, stored as ranges, so that millions of seeds need little memory."""

import bisect
import itertools
import re
from typing import Iterator, List, Optional, Sequence

from .input_file import shown
from .mistakes import BadInput

LARGEST_SEED = 2 ** 64 - 1
MOST_RUNS = 10_000_000
ALLOWED = "seeds and ranges of seeds, such as 1..1000 or 1,2,10..20"


class Seeds:
    """A sequence of distinct seeds, in the given order."""

    def __init__(self, ranges: Sequence[range]) -> None:
        """@param ranges disjoint ranges"""
        self._ranges = tuple(ranges)
        self._ends = list(itertools.accumulate(map(len, self._ranges)))   # index after the last seed of each range
        self._sorted = sorted(range(len(self._ranges)), key=lambda number: self._ranges[number].start)
        self._starts = [self._ranges[number].start for number in self._sorted]

    def __len__(self) -> int:
        return self._ends[-1] if self._ends else 0

    def __iter__(self) -> Iterator[int]:
        return itertools.chain.from_iterable(self._ranges)

    def __getitem__(self, place: int) -> int:
        number = bisect.bisect_right(self._ends, place)
        return self._ranges[number][place - self._ends[number]]   # from the end of the range

    def place(self, seed: int) -> Optional[int]:
        """Index of a seed, the inverse of []; None if it is not in the sequence."""
        found = bisect.bisect_right(self._starts, seed) - 1
        number = self._sorted[found] if found >= 0 else 0
        if found < 0 or seed not in self._ranges[number]:
            return None
        return self._ends[number] - len(self._ranges[number]) + seed - self._ranges[number].start


def parse_seeds(text: str, option: str = "--seeds", most: int = MOST_RUNS) -> Seeds:
    """Parses "1..5,8" to 1, 2, 3, 4, 5, 8. @raise BadInput"""
    ranges: List[range] = []
    for part in text.split(","):
        found = re.fullmatch(r"\s*(\d{1,20})\s*(?:\.\.\s*(\d{1,20})\s*)?", part, re.ASCII)
        first, last = (int(found[1]), int(found[2] or found[1])) if found else (1, 0)
        if first > last or last > LARGEST_SEED:
            raise BadInput(f"{option}: found '{shown(text)}', allowed: {ALLOWED}")
        ranges.append(range(first, last + 1))
    count = sum(last.stop - last.start for last in ranges)   # len() of a range is limited
    if count > most:
        raise BadInput(f"{option}: found {count} seeds, allowed: up to {most}")
    ordered = sorted(ranges, key=lambda one: one.start)
    for one, other in zip(ordered, ordered[1:]):
        if other.start < one.stop:
            raise BadInput(f"{option}: found '{other.start}' twice, allowed: once")
    return Seeds(ranges)

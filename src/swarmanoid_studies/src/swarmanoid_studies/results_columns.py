"""The columns of a batch's CSV file."""

import collections
from typing import List, NamedTuple, Sequence, Tuple

from .identity_fields import Identity
from .input_file import shown
from .mistakes import BadInput

OUTCOME = ("success", "ticks", "wall_s", "state_hash", "failure", "overrides")


class Columns(NamedTuple):
    """The columns that depend on the batch; all files share the others."""
    paths: Tuple[str, ...]
    metrics: Tuple[str, ...]

    def names(self) -> List[str]:
        return [*Identity._fields, *self.paths, "seed", *OUTCOME, *self.metrics]


def columns_of(header: Sequence[str], file: str) -> Columns:
    """@raise BadInput if the header is not of a batch"""
    own = len(Identity._fields)
    for name, count in collections.Counter(header).items():
        if count > 1:
            raise BadInput(f"{file}:1: found the column '{shown(name)}' {count} times, allowed: once")
    if tuple(header[:own]) == Identity._fields and "seed" in header:
        seed = header.index("seed")
        metrics = seed + 1 + len(OUTCOME)
        if tuple(header[seed + 1:metrics]) == OUTCOME:
            return Columns(tuple(header[own:seed]), tuple(header[metrics:]))
    raise BadInput(f"{file}:1: found other columns, allowed: those of a CSV file that `swarmanoid batch` has written")

"""The columns of a batch's CSV file."""

from typing import List, NamedTuple, Sequence, Tuple

from .identity_fields import Identity
from .mistakes import BadInput

OUTCOME = ("success", "ticks", "wall_s", "state_hash", "failure", "overrides")


class Columns(NamedTuple):
    """The columns of a file between those that all files have."""
    paths: Tuple[str, ...]
    metrics: Tuple[str, ...]

    def names(self) -> List[str]:
        return [*Identity._fields, *self.paths, "seed", *OUTCOME, *self.metrics]


def columns_of(header: Sequence[str], file: str) -> Columns:
    """@raise BadInput if it is no file of a batch"""
    own = len(Identity._fields)
    if tuple(header[:own]) == Identity._fields and "seed" in header:
        seed = header.index("seed")
        metrics = seed + 1 + len(OUTCOME)
        if tuple(header[seed + 1:metrics]) == OUTCOME:
            return Columns(tuple(header[own:seed]), tuple(header[metrics:]))
    raise BadInput(f"{file}:1: found other columns, allowed: those of a CSV file that `swarmanoid batch` has written")

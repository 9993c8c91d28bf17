"""One run: what is asked for, and what comes of it. Plain values, which any process can be sent."""

from typing import Dict, NamedTuple, Optional, Tuple, Union

from .contents_fields import Contents

Metric = Union[float, str, bool]
MOST_FAILURE = 10_000   # characters


class RunRequest(NamedTuple):
    experiment: str                          # a file, or the name of an installed experiment
    overrides: Tuple[Tuple[str, str], ...]   # path and value, as of --set
    seed: int
    expected: Optional[Contents] = None      # what the run is to be made of; None: whatever the worker finds


class RunOutcome(NamedTuple):
    metrics: Dict[str, Metric]
    success: Optional[bool]    # None: nothing in the experiment judges it
    ticks: int
    wall_s: float              # from the request to the result, all tries [s]
    state_hash: str            # of the last state
    failure: str               # what went wrong, in one line, see failure_text; "": nothing
    is_complete: bool          # the run went to its end, though controllers may have failed


def lost(reason: str) -> RunOutcome:
    """Of a run that has no result."""
    return RunOutcome({}, None, 0, 0.0, "", failure_text(reason), False)


def failure_text(text: str) -> str:
    """One line, and not longer than fits well into a row."""
    return one_line(text)[:MOST_FAILURE]


def one_line(text: str) -> str:
    return " ".join(text.split())

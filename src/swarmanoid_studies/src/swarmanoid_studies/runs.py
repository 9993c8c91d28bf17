"""Request and outcome of one run: plain values, which can be sent to any process."""

from typing import Dict, NamedTuple, Optional, Tuple, Union

from .contents_fields import Contents

Metric = Union[float, str, bool]
MOST_FAILURE = 10_000   # characters


class RunRequest(NamedTuple):
    experiment: str                          # a file, or the name of an installed experiment
    overrides: Tuple[Tuple[str, str], ...]   # path and value, as of --set
    seed: int
    expected: Optional[Contents] = None      # contents that the run must have; None: no check


class RunOutcome(NamedTuple):
    metrics: Dict[str, Metric]
    success: Optional[bool]    # None: no rule judges the run
    ticks: int
    wall_s: float              # from request to result, with all tries [s]
    state_hash: str            # of the last state
    failure: str               # reason in one line, see failure_text; "": no failure
    is_complete: bool          # the run went to its end, though controllers may have failed


def lost(reason: str) -> RunOutcome:
    """The outcome of a run without a result."""
    return RunOutcome({}, None, 0, 0.0, "", failure_text(reason), False)


def failure_text(text: str) -> str:
    """Text as one line, cut to MOST_FAILURE characters."""
    return one_line(text)[:MOST_FAILURE]


def one_line(text: str) -> str:
    return " ".join(text.split())

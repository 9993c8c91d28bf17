"""Identity of runs. identity.py computes it, and needs the simulator."""

from typing import NamedTuple


class Identity(NamedTuple):
    experiment: str     # its name
    version: str        # of the suite, with the commit
    math_library: str
    fingerprint: str    # of the experiment's text with shared overrides, and of the files and libraries it names


IDENTITY = Identity._fields

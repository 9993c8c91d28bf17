"""What makes two runs comparable; who computes it is identity.py, which needs the simulator."""

from typing import NamedTuple


class Identity(NamedTuple):
    experiment: str     # its name
    version: str        # of the suite, with the commit
    math_library: str
    fingerprint: str    # of the experiment's text, with overrides that all runs share, of the files and libraries it names


IDENTITY = Identity._fields

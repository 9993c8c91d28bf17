"""Contents of runs. contents.py computes them, and needs the simulator."""

from typing import Dict, FrozenSet, NamedTuple


class Contents(NamedTuple):
    """Plain values, which can be sent to any process."""
    version: str
    math_library: str
    python: str
    numpy: str
    digests: Dict[str, FrozenSet[str]]   # by file, without its folder; several files may have one name


class OtherContents(Exception):
    """A worker has other contents, so it would make other runs."""

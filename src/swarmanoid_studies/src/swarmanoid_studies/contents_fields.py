"""What runs are made of; who computes it is contents.py, which needs the simulator."""

from typing import Dict, FrozenSet, NamedTuple


class Contents(NamedTuple):
    """Plain values, which any process can be sent."""
    version: str
    math_library: str
    python: str
    numpy: str
    digests: Dict[str, FrozenSet[str]]   # by file, without its folder; several files may have one name


class OtherContents(Exception):
    """A worker would make other runs."""

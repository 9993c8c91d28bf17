"""State of an evolution: genotypes and values of each generation so far.

An evolution needs no other state to continue: its optimiser receives the same losses again, and asks for the same genotypes again,
to the last bit. The file is JSON, and replaced atomically after each generation. A digest detects changed values, which would
otherwise only change the course of the evolution."""

import hashlib
import json
import math
from typing import Dict, List, NamedTuple, Optional

from .atomic_file import write_atomically
from .input_file import read_file, shown
from .mistakes import BadInput

FORMAT = 2
MOST_BYTES = 4_000_000_000


class Generation(NamedTuple):
    genotypes: List[List[float]]            # (genotypes, genes), fractions of the ranges, from 0 to 1
    values: List[List[Optional[float]]]     # (genotypes, objectives), means of metrics over the seeds; None: not finite
    failed_controllers: int                 # runs in which a controller failed
    first_failures: List[str]               # the first such runs: genotype, seed, controllers and reasons


def finite(value: float) -> Optional[float]:
    return value if math.isfinite(value) else None


def write_checkpoint(path: str, made_of: Dict[str, object], generations: List[Generation]) -> None:
    """@param made_of properties that must be equal when the evolution is continued @raise RunsStopped"""
    content = {"format": FORMAT, **made_of, "generations": [generation._asdict() for generation in generations]}
    content["digest"] = _digest(content)
    write_atomically(path, (json.dumps(content, indent=1, allow_nan=False) + "\n").encode())


def read_checkpoint(path: str, made_of: Dict[str, object]) -> List[Generation]:
    """@raise BadInput if the file is damaged, or of another evolution"""
    content = _undamaged(path)
    for name, own in made_of.items():
        _require(path, content, name, own)
    return [Generation(**generation) for generation in content["generations"]]


def _require(path: str, content: Dict[str, object], name: str, own: object) -> None:
    """@raise BadInput"""
    if content.get(name) != own:
        raise BadInput(f"{path}: {name}: found {shown(json.dumps(content.get(name)))}, allowed: {shown(json.dumps(own))}, as now")


def _digest(content: Dict[str, object]) -> str:
    """Digest of all entries except the digest itself."""
    others = {name: value for name, value in content.items() if name != "digest"}
    return hashlib.sha256(json.dumps(others).encode()).hexdigest()[:16]


def _undamaged(path: str) -> Dict[str, object]:
    """@raise BadInput"""
    try:
        content = json.loads(read_file(path, MOST_BYTES).decode())
        if isinstance(content, dict):
            _require(path, content, "format", FORMAT)   # first: other formats have other digests, or none
            if content.get("digest") == _digest(content):
                return content
    except json.JSONDecodeError as error:
        raise BadInput(f"{path}:{error.lineno}: {error.msg}, allowed: a checkpoint as `swarmanoid evolve` has written it") from None
    except (ValueError, RecursionError):  # invalid UTF-8, numbers of thousands of digits, deeply nested lists
        pass
    raise BadInput(f"{path}: is damaged: its content and its digest differ, allowed: a checkpoint as `swarmanoid evolve` has written it")

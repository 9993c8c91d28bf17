"""What an evolution has found so far: each generation's genotypes and what they were worth.

That is all that it needs to go on: its optimiser is told again what it was told before, and asks for the same genotypes again, to
the last bit. The file is JSON, and replaced as a whole after each generation."""

import json
import math
from typing import Dict, List, NamedTuple, Optional

from .atomic_file import write_atomically
from .mistakes import BadInput

FORMAT = 1


class Generation(NamedTuple):
    genotypes: List[List[float]]            # (genotypes, genes), parts of the ranges, from 0 to 1
    values: List[List[Optional[float]]]     # (genotypes, objectives), means of metrics over the seeds; None: not finite
    failed_controllers: int                 # runs in which a controller failed
    first_failures: List[str]               # of the first of them: genotype, seed, which controllers and why


def finite(value: float) -> Optional[float]:
    return value if math.isfinite(value) else None


def write_checkpoint(path: str, made_of: Dict[str, object], generations: List[Generation]) -> None:
    """@param made_of what must be the same when it is continued @raise OSError"""
    content = {"format": FORMAT, **made_of, "generations": [generation._asdict() for generation in generations]}
    write_atomically(path, (json.dumps(content, indent=1, allow_nan=False) + "\n").encode())


def read_checkpoint(path: str, made_of: Dict[str, object]) -> List[Generation]:
    """@raise BadInput if it is of something else"""
    try:
        with open(path, encoding="utf-8") as file:
            content = json.load(file)
        for name, own in {"format": FORMAT, **made_of}.items():
            if content[name] != own:
                raise BadInput(f"{path}: {name}: found {json.dumps(content[name])}, allowed: {json.dumps(own)}, as now")
        return [Generation(**generation) for generation in content["generations"]]
    except OSError as error:
        raise BadInput(f"{path}: cannot be continued: {error.strerror}") from None
    except (ValueError, KeyError, TypeError) as error:
        raise BadInput(f"{path}: is no checkpoint of an evolution: {type(error).__name__}: {error}") from None

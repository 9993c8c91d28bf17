"""A study: an experiment, the numbers to evolve, the objectives, and the optimiser."""

from typing import Dict, List, NamedTuple, Sequence, Tuple, Union


class Gene(NamedTuple):
    """An evolved number of the experiment file, or several numbers of one value, separated by commas."""
    path: str
    minimum: float     # of each number
    maximum: float
    where: str         # file and line
    count: int = 0     # of numbers; 0: a single number, <gene>

    def size(self) -> int:
        return max(1, self.count)

    def value(self, part: float) -> float:
        """@param part fraction of the range, from 0 to 1"""
        return self.minimum + part * (self.maximum - self.minimum)

    def names(self) -> List[str]:
        """Names of the numbers."""
        return [f"{self.path}[{i}]" for i in range(self.count)] or [self.path]


class Objective(NamedTuple):
    metric: str
    is_minimised: bool
    where: str         # file and line


class OptimiserChoice(NamedTuple):
    kind: str
    parameters: Dict[str, float]


class Study(NamedTuple):
    name: str         # of the file, without folder and ending
    experiment: str   # a file, or the name of an installed experiment
    overrides: Dict[str, str]
    genes: Tuple[Gene, ...]
    seeds: Tuple[int, ...]
    objectives: Tuple[Objective, ...]
    optimiser: OptimiserChoice

    def size(self) -> int:
        """Total number of evolved numbers."""
        return sum(gene.size() for gene in self.genes)

    def values(self, genotype: Sequence[float]) -> Dict[str, Union[float, List[float]]]:
        """Values for the experiment, by path. @param genotype (size) fractions of the ranges, from 0 to 1"""
        parts = iter(genotype)
        values = {gene.path: [gene.value(next(parts)) for _ in range(gene.size())] for gene in self.genes}
        return {gene.path: values[gene.path] if gene.count else values[gene.path][0] for gene in self.genes}

    def texts(self, genotype: Sequence[float]) -> Dict[str, str]:
        """Same as `values`, as text of the experiment, with all digits."""
        return {path: ", ".join(map(repr, value)) if isinstance(value, list) else repr(value)
                for path, value in self.values(genotype).items()}

"""What a study is: an experiment, which of its numbers are evolved, what for, and by which optimiser."""

from typing import Dict, List, NamedTuple, Sequence, Tuple, Union


class Gene(NamedTuple):
    """A number of the experiment file that is evolved, or several numbers of one value, separated by commas."""
    path: str
    minimum: float     # of each number
    maximum: float
    where: str         # file and line
    count: int = 0     # of numbers; 0: <gene>, a single one

    def size(self) -> int:
        return max(1, self.count)

    def value(self, part: float) -> float:
        """@param part of the range, from 0 to 1"""
        return self.minimum + part * (self.maximum - self.minimum)

    def names(self) -> List[str]:
        """Of its numbers."""
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
        """How many numbers are evolved."""
        return sum(gene.size() for gene in self.genes)

    def values(self, genotype: Sequence[float]) -> Dict[str, Union[float, List[float]]]:
        """What the experiment gets, by path. @param genotype (size) parts of the ranges, from 0 to 1"""
        parts = iter(genotype)
        values = {gene.path: [gene.value(next(parts)) for _ in range(gene.size())] for gene in self.genes}
        return {gene.path: values[gene.path] if gene.count else values[gene.path][0] for gene in self.genes}

    def texts(self, genotype: Sequence[float]) -> Dict[str, str]:
        """The same as it is written into the experiment, with all digits."""
        return {path: ", ".join(map(repr, value)) if isinstance(value, list) else repr(value)
                for path, value in self.values(genotype).items()}

"""Optimisers of DEAP behind one interface: `ask` for a population, `tell` its losses, generation by generation.

Genotypes are lists of numbers from 0 to 1, fractions of the genes' ranges; losses are minimised. An optimiser is a deterministic
function of its seed and the losses passed to `tell`, so an evolution is continued by passing the same losses again.

DEAP draws from the global generators of the process, which threads of Dask use, too. Therefore DEAP's modules get a generator of
their own during each call."""

import contextlib
import functools
import math
import random
from typing import Dict, Iterator, List, Protocol, Sequence, Tuple, Type

import numpy
from deap import base, cma, tools
from deap.tools import crossover, emo, mutation, selection

from .study import OptimiserChoice

Genotype = List[float]
Losses = Tuple[float, ...]
DISTRIBUTION = 20.0   # index of simulated binary crossover and polynomial mutation, as in the NSGA-II paper
TOURNAMENT = 3
WORST = 1e300         # replaces a loss that is not finite, so that losses can be compared and subtracted


class Optimiser(Protocol):
    def ask(self) -> List[Genotype]: ...
    def tell(self, losses: Sequence[Losses]) -> None: ...


@functools.lru_cache(maxsize=None)
def _fitness_type(objectives: int) -> Type[base.Fitness]:
    return type("Fitness", (base.Fitness,), {"weights": (-1.0,) * objectives})


class _Individual(list):
    """A genotype with its fitness, in the form that DEAP requires."""

    def __init__(self, values: Sequence[float], objectives: int) -> None:
        super().__init__(float(value) for value in values)
        self.fitness = _fitness_type(objectives)()


def _judge(population: Sequence[_Individual], losses: Sequence[Losses]) -> None:
    for individual, values in zip(population, losses):
        individual.fitness.values = tuple(value if math.isfinite(value) else WORST for value in values)


@contextlib.contextmanager
def _drawing_from(generator: random.Random) -> Iterator[None]:
    modules = (crossover, emo, mutation, selection)
    before = [module.random for module in modules]
    try:
        for module in modules:
            module.random = generator
        yield
    finally:
        for module, own in zip(modules, before):
            module.random = own


def reflected(value: float) -> float:
    """Reflects values outside 0 to 1 at the ends, so that all genotypes are valid."""
    value = abs(value) % 2.0
    return 2.0 - value if value > 1.0 else value


class CmaEs(cma.Strategy):
    """Covariance matrix adaptation. `random_seed` determines the start."""

    def __init__(self, genes: int, objectives: int, parameters: Dict[str, float]) -> None:
        self._generator = numpy.random.Generator(numpy.random.PCG64(int(parameters["random_seed"])))
        self._objectives = objectives
        self._asked: List[_Individual] = []
        population = int(parameters["population"]) or 4 + int(3 * math.log(genes))
        super().__init__(self._generator.random(genes), parameters["sigma"], lambda_=max(4, population))

    def ask(self) -> List[Genotype]:
        steps = self._generator.standard_normal((self.lambda_, self.dim))
        points = self.centroid + self.sigma * numpy.dot(steps, self.BD.T)
        self._asked = [_Individual(point, self._objectives) for point in points]
        return [[reflected(value) for value in individual] for individual in self._asked]

    def tell(self, losses: Sequence[Losses]) -> None:
        _judge(self._asked, losses)
        self.update(self._asked)


class _Genetic:
    """Base of the genetic algorithms: simulated binary crossover and polynomial mutation, within 0 to 1."""

    def __init__(self, genes: int, objectives: int, parameters: Dict[str, float]) -> None:
        self._generator = random.Random(int(parameters["random_seed"]))
        self._objectives = objectives
        self._size = int(parameters["population"])
        self._crossover = parameters["crossover"]
        self._mutation = parameters["mutation"] or 1.0 / genes  # probability per gene
        self._parents: List[_Individual] = []
        self._asked = [self._new([self._generator.random() for _ in range(genes)]) for _ in range(self._size)]

    def ask(self) -> List[Genotype]:
        return [list(individual) for individual in self._asked]

    def _new(self, values: Sequence[float]) -> _Individual:
        return _Individual(values, self._objectives)

    def _offspring(self, chosen: Sequence[_Individual]) -> List[_Individual]:
        children = [self._new(individual) for individual in chosen]
        for mother, father in zip(children[::2], children[1::2]):
            if self._generator.random() < self._crossover:
                tools.cxSimulatedBinaryBounded(mother, father, DISTRIBUTION, 0.0, 1.0)
        for child in children:
            tools.mutPolynomialBounded(child, DISTRIBUTION, 0.0, 1.0, self._mutation)
        return children


class GeneticAlgorithm(_Genetic):
    """Tournament selection; the best genotype so far survives."""

    def tell(self, losses: Sequence[Losses]) -> None:
        _judge(self._asked, losses)
        with _drawing_from(self._generator):
            best = tools.selBest([*self._asked, *self._parents], 1)
            chosen = tools.selTournament(self._asked, self._size, TOURNAMENT)
            self._parents = best
            self._asked = [self._new(best[0]), *self._offspring(chosen)[1:]]


class Nsga2(_Genetic):
    """Several objectives: non-dominated sorting and crowding distance (Deb et al. 2002)."""

    def tell(self, losses: Sequence[Losses]) -> None:
        _judge(self._asked, losses)
        with _drawing_from(self._generator):
            self._parents = tools.selNSGA2([*self._parents, *self._asked], self._size)
            self._asked = self._offspring(tools.selTournamentDCD(self._parents, self._size))


KINDS = {"cma_es": CmaEs, "ga": GeneticAlgorithm, "nsga2": Nsga2}


def make_optimiser(choice: OptimiserChoice, genes: int, objectives: int) -> Optimiser:
    return KINDS[choice.kind](genes, objectives, choice.parameters)


def front(losses: Sequence[Losses]) -> List[int]:
    """Indices of the non-dominated losses, ordered by the first objective."""
    individuals = [_Individual([index], len(losses[0])) for index in range(len(losses))]
    _judge(individuals, losses)
    found = tools.sortNondominated(individuals, len(individuals), first_front_only=True)[0] if individuals else []
    return sorted((int(individual[0]) for individual in found), key=lambda index: (losses[index], index))

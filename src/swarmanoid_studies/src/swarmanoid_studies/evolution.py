"""An evolution: generations of genotypes, each evaluated by the mean of its metrics over the seeds of the study."""

import math
from typing import Callable, Dict, List, NamedTuple, Optional, Sequence, Tuple

from distributed import Client

from .checkpoint import Generation, finite
from .contents_fields import Contents
from .dispatch import outcomes
from .mistakes import BadInput, RunsStopped
from .optimisers import Losses, front, make_optimiser
from .runs import RunOutcome, RunRequest
from .study import Study


MOST_FAILURES = 10   # failures of a generation that are reported individually


class Found(NamedTuple):
    """An evaluated genotype."""
    generation: int    # from 1
    index: int         # in its generation, from 0
    genotype: Tuple[float, ...]
    values: Tuple[Optional[float], ...]


class Evolution:
    def __init__(self, study: Study, experiment: str, expected: Optional[Contents] = None) -> None:
        """@param experiment its name for workers @param expected contents that all runs must have"""
        self._study = study
        self._experiment = experiment
        self._expected = expected
        self._optimiser = make_optimiser(study.optimiser, study.size(), len(study.objectives))
        self._asked = self._optimiser.ask()
        self.generations: List[Generation] = []
        self.best: List[Found] = []    # one genotype, or the Pareto front of several objectives

    def population(self) -> int:
        return len(self._asked)

    def replay(self, generations: Sequence[Generation]) -> None:
        """Repeats earlier generations. @raise BadInput if the optimiser asks for other genotypes, as other versions of it may"""
        for generation in generations:
            if generation.genotypes != self._asked:
                raise BadInput(f"generation {len(self.generations) + 1} of the checkpoint: found other genotypes than the "
                               "optimiser asks for here, allowed: a checkpoint of the same versions of NumPy and DEAP")
            self.take(generation)

    def make(self, client: Client, note: Callable[[RunOutcome], None]) -> Generation:
        """Makes the runs of the next generation. @param note called after each run @raise RunsStopped"""
        requests = [request for genotype in self._asked for request in self._requests(genotype)]
        made: List[Optional[RunOutcome]] = [None] * len(requests)
        for number, outcome in outcomes(client, enumerate(requests), len(requests)):
            if not outcome.is_complete:
                raise RunsStopped(f"generation {len(self.generations) + 1}: a run has no result: {outcome.failure} "
                                  f"({_text(requests[number])})")
            made[number] = outcome
            note(outcome)
        runs = len(self._study.seeds)
        values = [self._values([outcome for outcome in made[first:first + runs] if outcome is not None])
                  for first in range(0, len(made), runs)]
        failures = [f"genotype {number // runs}, seed {requests[number].seed}: {outcome.failure}"
                    for number, outcome in enumerate(made) if outcome is not None and outcome.failure]
        return Generation(self._asked, values, len(failures), failures[:MOST_FAILURES])

    def take(self, generation: Generation) -> None:
        """Adds the next generation: the optimiser receives its losses, and supplies the genotypes of the following one."""
        losses = [self._losses(values) for values in generation.values]
        self.generations.append(generation)
        number = len(self.generations)
        judged = [*self.best, *(Found(number, index, tuple(genotype), tuple(values)) for index, (genotype, values)
                                in enumerate(zip(generation.genotypes, generation.values)))]
        different = list({found.genotype: found for found in reversed(judged)}.values())[::-1]  # keeps the oldest of equal genotypes
        order = front([self._losses(found.values) for found in different])
        self.best = [different[index] for index in order[:1 if len(self._study.objectives) == 1 else None]]
        self._optimiser.tell(losses)
        self._asked = self._optimiser.ask()

    def overrides(self, genotype: Sequence[float]) -> Dict[str, str]:
        """Overrides of the experiment for a genotype, with all digits."""
        return {**self._study.overrides, **self._study.texts(genotype)}

    def _requests(self, genotype: Sequence[float]) -> List[RunRequest]:
        overrides = tuple(self.overrides(genotype).items())
        return [RunRequest(self._experiment, overrides, seed, self._expected) for seed in self._study.seeds]

    def _values(self, runs: Sequence[RunOutcome]) -> List[Optional[float]]:
        """Means over the runs. They are summed in the order of the seeds, so the order of completion changes no bit."""
        return [finite(math.fsum(float(run.metrics[objective.metric]) for run in runs) / len(runs))
                for objective in self._study.objectives]

    def _losses(self, values: Sequence[Optional[float]]) -> Losses:
        return tuple(math.inf if value is None else value if objective.is_minimised else -value
                     for value, objective in zip(values, self._study.objectives))


def _text(request: RunRequest) -> str:
    return ", ".join(f"{path}={value}" for path, value in request.overrides) + f", seed {request.seed}"

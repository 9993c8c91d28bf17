"""Output files of an evolution: a table, a picture, and the best genotypes as experiment files."""

import itertools
import json
import os
from typing import List, Optional, Sequence

from .atomic_file import write_atomically
from .evolution import Evolution, Found
from .identity import checked
from .identity_fields import IDENTITY, Identity
from .pictures import png, pyplot
from .results_file import line_of, text_of
from .study import Study

WIDE = 100   # ratio of largest to smallest value above which a picture has a logarithmic axis


def write_files(folder: str, study: Study, identity: Identity, evolution: Evolution) -> List[str]:
    """@return paths of the experiment files @raise OSError"""
    write_atomically(os.path.join(folder, "generations.csv"), _table(study, identity, evolution))
    write_picture(folder, study, evolution)
    return _experiments(folder, study, identity, evolution)


def write_picture(folder: str, study: Study, evolution: Evolution) -> None:
    """Draws the generations so far. @raise OSError"""
    draw = _history if len(study.objectives) == 1 else _front
    write_atomically(os.path.join(folder, "fitness.png"), draw(study, evolution))


def _table(study: Study, identity: Identity, evolution: Evolution) -> bytes:
    """One row per genotype, with all data that reproduce its runs."""
    made_of = [*identity, " ".join(map(str, study.seeds))]
    lines = [line_of([*IDENTITY, "seeds", "overrides", "generation", "genotype", *(name for gene in study.genes for name in gene.names()),
                      *(each.metric for each in study.objectives)])]
    for number, generation in enumerate(evolution.generations, 1):
        for index, (genotype, values) in enumerate(zip(generation.genotypes, generation.values)):
            genes = (value if isinstance(value, list) else [value] for value in study.values(genotype).values())
            overrides = json.dumps([f"{path}={value}" for path, value in evolution.overrides(genotype).items()])
            lines.append(line_of([*made_of, overrides, number, index, *itertools.chain(*genes), *values]))
    return b"".join(lines)


def _experiments(folder: str, study: Study, identity: Identity, evolution: Evolution) -> List[str]:
    """Writes best.xml for one objective, or front_1.xml and so on for several, ordered by the first objective."""
    names = ["best.xml"] if len(study.objectives) == 1 else [f"front_{i}.xml" for i in range(1, len(evolution.best) + 1)]
    for name in os.listdir(folder):
        if name.startswith("front_") and name.endswith(".xml") and name not in names:
            os.unlink(os.path.join(folder, name))  # from a longer front
    paths = [os.path.join(folder, name) for name in names]
    for path, found in zip(paths, evolution.best):
        record = checked(study.experiment, evolution.overrides(found.genotype)).record
        for name, content in record["files"].items():  # images that the experiment names
            os.makedirs(os.path.dirname(os.path.join(folder, name)), exist_ok=True)
            write_atomically(os.path.join(folder, name), content)
        head, line, rest = record["text"].partition("\n")
        write_atomically(path, f"{head}{line}<!-- {_comment(study, identity, evolution, found)} -->\n{rest}".encode())
    return paths


def _comment(study: Study, identity: Identity, evolution: Evolution, found: Found) -> str:
    values = ", ".join(f"{objective.metric} {text_of(value)}" for objective, value in zip(study.objectives, found.values))
    text = f"Evolved by the study {study.name}, generation {found.generation}: {values} over {len(study.seeds)} seeds.\n"
    text += f"Seeds: {' '.join(map(str, study.seeds))}. Version: {identity.version}, {identity.math_library}.\n"
    text += f"Experiment: {identity.experiment}, fingerprint {identity.fingerprint}, with "
    text += ", ".join(f"{path}={value}" for path, value in evolution.overrides(found.genotype).items()) + "."
    return text.replace("--", "- -")  # not allowed in XML comments


def _finite(values: Sequence[Optional[float]]) -> List[float]:
    return [value for value in values if value is not None]


def _history(study: Study, evolution: Evolution) -> bytes:
    """Draws one objective by generation: best, mean, and all values."""
    objective, = study.objectives
    choose = min if objective.is_minimised else max
    figure, axes = pyplot.subplots(figsize=(7, 4.5))
    numbers, best, means = [], [], []
    for number, generation in enumerate(evolution.generations, 1):
        values = _finite([row[0] for row in generation.values])
        axes.plot([number] * len(values), values, ".", color="tab:blue", alpha=0.4)
        if values:
            numbers.append(number)
            means.append(sum(values) / len(values))
            best.append(choose([*best[-1:], choose(values)]))
    axes.plot(numbers, means, color="tab:blue", label="mean of the generation")
    axes.plot(numbers, best, color="black", label="best so far")
    judged = _finite([row[0] for generation in evolution.generations for row in generation.values])
    if judged and min(judged) > 0 and max(judged) > WIDE * min(judged):
        axes.set_yscale("log")
    axes.set_xlabel("generation")
    axes.set_ylabel(f"{objective.metric}, mean over {len(study.seeds)} seeds")
    axes.legend()
    return _finished(figure, study)


def _front(study: Study, evolution: Evolution) -> bytes:
    """Draws the first two objectives against each other, by generation, and the front."""
    figure, axes = pyplot.subplots(figsize=(7, 4.5))
    points = [(number, *row[:2]) for number, generation in enumerate(evolution.generations, 1) for row in generation.values
              if row[0] is not None and row[1] is not None]
    if points:
        numbers, first, second = zip(*points)
        figure.colorbar(axes.scatter(first, second, c=numbers, s=8), label="generation")
    line = [found.values[:2] for found in evolution.best if None not in found.values[:2]]
    if line:
        axes.plot(*zip(*line), ".-", color="black", label="front")
        axes.legend()
    axes.set_xlabel(study.objectives[0].metric)
    axes.set_ylabel(study.objectives[1].metric)
    return _finished(figure, study)


def _finished(figure: pyplot.Figure, study: Study) -> bytes:
    """@return the figure as PNG"""
    figure.axes[0].set_title(study.name)
    figure.axes[0].grid(alpha=0.3)
    return png(figure)

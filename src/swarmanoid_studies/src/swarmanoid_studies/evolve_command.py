"""`swarmanoid evolve`: evolves parameters of an experiment, as defined by a study file."""

import argparse
import json
import os
import sys
import time
from typing import TYPE_CHECKING, Callable, Dict, List

from .atomic_file import lock
from .command_options import add_worker_options, check_worker_options, portable, refuse_resume_with_force
from .contents import contents_of
from .identity import checked, identity_of
from .identity_fields import Identity
from .mistakes import CONTROLLER_FAILED, FINISHED, Arguments, BadInput, call, interrupted, interrupts_held, print_result
from .progress import Progress
from .study import Study
from .study_file import MOST, find_study, read_study
from .workers import connected, refuse_others

if TYPE_CHECKING:
    from distributed import Client

    from .evolution import Evolution

MOST_TOLD = 10   # runs with failed controllers that are reported individually


def _arguments() -> Arguments:
    parser = Arguments("evolve", "Evolves parameters of an experiment, as a study file says. Writes a folder.")
    parser.add_argument("study", help="a study file, or the name of an installed study")
    parser.add_argument("--generations", type=int, metavar="N", help="instead of those of the file")
    add_worker_options(parser)
    parser.add_argument("--out", metavar="FOLDER", help="without it STUDY_evolution")
    parser.add_argument("--resume", action="store_true", help="goes on after the last generation in the folder")
    parser.add_argument("--force", action="store_true", help="replaces what is in the folder")
    parser.add_argument("--quiet", action="store_true", help="no progress bar")
    return parser


def _refuse_bad_values(study: Study) -> None:
    """Builds the experiment with both ends of each range and the middle of all other ranges. @raise BadInput"""
    middle = study.texts([0.5] * study.size())
    for gene in study.genes:
        for part in (0.0, 1.0):
            end = study.texts([part] * study.size())[gene.path]
            try:
                metrics = checked(study.experiment, {**study.overrides, **middle, gene.path: end}).metrics
            except BadInput as mistake:
                raise BadInput(f"{gene.where}: {mistake}") from None
    numbers = [name for name, value in metrics.items() if not isinstance(value, str)]
    for objective in study.objectives:
        if objective.metric not in numbers:
            raise BadInput(f"{objective.where}: found the metric '{objective.metric}', allowed: {', '.join(numbers) or 'none'}")


def made_of(study: Study, identity: Identity) -> Dict[str, object]:
    """Properties that must be equal when an evolution is continued; the number of generations may differ."""
    parameters = {name: value for name, value in study.optimiser.parameters.items() if name != "generations"}
    return {**identity._asdict(), "overrides": study.overrides,
            "genes": [[gene.path, gene.minimum, gene.maximum, gene.count] for gene in study.genes],
            "seeds": list(study.seeds), "objectives": [[each.metric, each.is_minimised] for each in study.objectives],
            "optimiser": study.optimiser.kind, "parameters": parameters}


def _open_folder(folder: str, checkpoint: str, arguments: argparse.Namespace) -> None:
    """Creates and locks the folder before the checkpoint is read, so that no other program adds to it meanwhile.
    @raise BadInput if the folder is in use, cannot be written, or has a checkpoint already"""
    if not arguments.resume and not arguments.force and os.path.lexists(checkpoint):
        raise BadInput(f"{checkpoint}: found a file, allowed: another --out, --resume to continue it, or --force to replace it")
    try:
        if not arguments.resume:
            os.makedirs(folder, exist_ok=True)
        lock(os.open(folder, os.O_RDONLY), folder)  # until the program ends
    except OSError as error:
        raise BadInput(f"{folder}: cannot be {'continued' if arguments.resume else 'written'}: {error.strerror}") from None


def main() -> int:
    return call(_main)


def _main() -> int:
    arguments = _arguments().parse_args()
    jobs = check_worker_options(arguments.jobs, arguments.scheduler)
    refuse_resume_with_force(arguments.resume, arguments.force)
    study = read_study(find_study(arguments.study))
    generations = int(study.optimiser.parameters["generations"]) if arguments.generations is None else arguments.generations
    if not 1 <= generations <= MOST:
        raise BadInput(f"--generations: found {generations}, allowed: 1 to {MOST}")
    _refuse_bad_values(study)
    simulation = checked(study.experiment, study.overrides)
    identity = identity_of(simulation)
    own = made_of(study, identity)
    from .checkpoint import read_checkpoint, write_checkpoint
    from .evolution import Evolution
    evolution = Evolution(study, portable(study.experiment), contents_of(simulation))
    folder = arguments.out or f"{study.name}_evolution"
    checkpoint = os.path.join(folder, "checkpoint.json")
    _open_folder(folder, checkpoint, arguments)
    evolution.replay(read_checkpoint(checkpoint, own) if arguments.resume else [])
    start = time.monotonic()
    is_interrupted = False
    if len(evolution.generations) < generations:
        with connected(jobs, arguments.scheduler) as client:
            if arguments.scheduler is not None:
                refuse_others(client, portable(study.experiment), study.overrides, identity)
            from .evolution_files import write_picture

            def keep() -> None:
                write_checkpoint(checkpoint, own, evolution.generations)
                write_picture(folder, study, evolution)

            is_interrupted = not _evolve(study, evolution, generations, client, arguments.quiet, keep)
    return _conclude(study, identity, evolution, folder, time.monotonic() - start, is_interrupted)


def _evolve(study: Study, evolution: "Evolution", generations: int, client: "Client", is_quiet: bool,
            keep: Callable[[], None]) -> bool:
    """@param keep called after each generation @return whether all generations were made"""
    runs = evolution.population() * len(study.seeds)
    progress = Progress(study.name, generations * runs, len(evolution.generations) * runs, is_quiet)
    try:
        while len(evolution.generations) < generations:
            generation = evolution.make(client, lambda outcome: progress.note(bool(outcome.failure)))
            with interrupts_held():
                evolution.take(generation)
                keep()
            progress.say(_line(study, evolution, generations))
        return True
    except KeyboardInterrupt:
        return False
    finally:
        progress.finish()


def _line(study: Study, evolution: "Evolution", generations: int) -> str:
    number = len(evolution.generations)
    if len(study.objectives) > 1:
        return f"generation {number} of {generations}: {len(evolution.best)} in the front"
    values: List[float] = [row[0] for row in evolution.generations[-1].values if row[0] is not None]
    mean = f", mean of the generation {sum(values) / len(values):.6g}" if values else ""
    best, = evolution.best[0].values
    return f"generation {number} of {generations}: best {study.objectives[0].metric} {best if best is None else format(best, '.6g')}{mean}"


def _conclude(study: Study, identity: Identity, evolution: "Evolution", folder: str, wall_s: float,
              is_interrupted: bool) -> int:
    files: List[str] = []
    if evolution.generations:
        from .evolution_files import write_files
        files = write_files(folder, study, identity, evolution)
    best = [{"file": file, "generation": found.generation,
             "values": {each.metric: value for each, value in zip(study.objectives, found.values)},
             "genes": study.values(found.genotype)}
            for file, found in zip(files, evolution.best)]
    failures = sum(generation.failed_controllers for generation in evolution.generations)
    told = [f"generation {number}, {failure}" for number, generation in enumerate(evolution.generations, 1)
            for failure in generation.first_failures][:MOST_TOLD]
    print_result(json.dumps({
        "study": study.name, "generations": len(evolution.generations), "population": evolution.population(),
        "runs_with_failed_controllers": failures, "first_failures": told, "folder": folder, "wall_s": round(wall_s, 3), "best": best}))
    if is_interrupted:
        return interrupted()
    if failures:
        lines = "".join(f"\n  {line}" for line in told)
        print(f"swarmanoid: controllers failed in {failures} runs, the first of them:{lines}", file=sys.stderr)
        return CONTROLLER_FAILED
    return FINISHED

"""`swarmanoid batch`: an experiment with many seeds and values, one row per run."""

import json
import os
import time
from typing import Dict, List, NamedTuple, Optional, Tuple

from .atomic_file import refuse_unwritable
from .command_options import add_worker_options, check_worker_options, portable, refuse_resume_with_force
from .contents import contents_of, merged
from .contents_fields import Contents
from .grid import Grid, Requests, parse_grid
from .identity import checked, identity_of
from .mistakes import CONTROLLER_FAILED, FINISHED, STOPPED, Arguments, BadInput, call, interrupted, interrupts_held, print_result
from .progress import Progress
from .results_file import Columns, ResultsFile

DESCRIPTION = "Runs an experiment with each seed and each combination of values. Writes one row a run into a CSV file, and a report."
TICKS_PATH = "framework.maxclock"


class Counts(NamedTuple):
    made: int = 0
    incomplete: int = 0           # runs without a result
    controllers_failed: int = 0   # runs that continued without some robots


def _arguments() -> Arguments:
    parser = Arguments("batch", DESCRIPTION)
    parser.add_argument("experiment", help="an experiment file, or the name of an installed experiment")
    parser.add_argument("--seeds", required=True, metavar="SEEDS", help="such as 1..1000 or 1,2,10..20")
    parser.add_argument("--set", dest="settings", action="append", default=[], metavar="PATH=A,B,C",
                        help=r"values that replace what the file says, each in turn (can be given again; a comma in a value: \,)")
    parser.add_argument("--ticks", type=int, help="at the most, instead of maxclock")
    add_worker_options(parser)
    parser.add_argument("--out", metavar="FILE", help="the CSV file; without it EXPERIMENT.csv")
    parser.add_argument("--resume", action="store_true", help="makes the runs that the file lacks")
    parser.add_argument("--force", action="store_true", help="replaces the file")
    parser.add_argument("--report", metavar="FILE", help=".html or .png; without it an .html beside the CSV file")
    parser.add_argument("--no-report", action="store_true")
    parser.add_argument("--quiet", action="store_true", help="no progress bar")
    return parser


def look_at_values(experiment: str, grid: Grid, shared: Dict[str, str]) -> Tuple[Tuple[str, ...], Contents]:
    """Builds the experiment once per value of each axis, with the first values of the other axes.
    @return names of metrics, and contents of all runs @raise BadInput"""
    first = {axis.path: axis.values[0] for axis in grid.axes}
    names: Dict[str, None] = {}
    contents: List[Contents] = []
    for axis in grid.axes or [None]:
        for value in axis.values if axis else [""]:
            overrides = {**shared, **first, **({axis.path: value} if axis else {})}
            simulation = checked(experiment, overrides)
            names.update(dict.fromkeys(simulation.metrics))
            contents.append(contents_of(simulation))
    return tuple(names), merged(contents)


def shared_overrides(grid: Grid, ticks: Optional[int]) -> Dict[str, str]:
    """@raise BadInput"""
    if ticks is None:
        return {}
    if any(axis.path == TICKS_PATH for axis in grid.axes):
        raise BadInput(f"found --ticks and --set {TICKS_PATH}, allowed: one of them")
    return {TICKS_PATH: str(ticks)}


def make_rows(results: ResultsFile, requests: Requests, done: bytearray, client, progress: Progress) -> Tuple[Counts, bool]:
    """@param done 1 for each run that already has a row
    @return counts of the runs made, and whether an interrupt stopped them"""
    from .dispatch import outcomes
    counts = Counts()
    try:
        missing = ((number, requests[number]) for number, is_done in enumerate(done) if not is_done)
        for number, outcome in outcomes(client, missing, done.count(0)):
            failed = bool(outcome.failure)
            with interrupts_held():
                results.append(requests[number], outcome)
                counts = Counts(counts.made + 1, counts.incomplete + (not outcome.is_complete),
                                counts.controllers_failed + (failed and outcome.is_complete))
            progress.note(failed)
        return counts, False
    except KeyboardInterrupt:
        return counts, True
    finally:
        progress.finish()


def main() -> int:
    return call(_main)


def _main() -> int:
    from .workers import connected, refuse_others
    arguments = _arguments().parse_args()
    grid = parse_grid(arguments.seeds, arguments.settings)
    jobs = check_worker_options(arguments.jobs, arguments.scheduler)
    refuse_resume_with_force(arguments.resume, arguments.force)
    shared = shared_overrides(grid, arguments.ticks)
    simulation = checked(arguments.experiment, shared)
    identity = identity_of(simulation)
    metrics, contents = look_at_values(arguments.experiment, grid, shared)
    columns = Columns(tuple(axis.path for axis in grid.axes), metrics)
    path = arguments.out or f"{identity.experiment}.csv"
    if not os.path.lexists(path) and not arguments.resume:
        refuse_unwritable(path)
    report = None if arguments.no_report else arguments.report or os.path.splitext(path)[0] + ".html"
    if report is not None:
        from .report_command import check_report_name
        check_report_name(report, path)

    results = ResultsFile(path, identity, columns)
    experiment = portable(arguments.experiment)
    requests = Requests(grid, experiment, shared, contents)
    done = results.resume(requests) if arguments.resume else bytearray(len(requests))
    if not arguments.resume and not arguments.force:
        results.refuse_existing()
    missing = done.count(0)

    counts, is_interrupted, wall_s = Counts(), False, 0.0
    if missing:
        with connected(jobs, arguments.scheduler) as client:
            if arguments.scheduler is not None:
                refuse_others(client, experiment, shared, identity)
            if not arguments.resume:
                results.create(arguments.force)  # after all checks of the input
            start = time.monotonic()
            counts, is_interrupted = make_rows(results, requests, done, client,
                                               Progress(identity.experiment, len(requests), done.count(1), arguments.quiet))
            wall_s = time.monotonic() - start  # without start and end of processes
    results.close()
    if report is not None and done.count(1) + counts.made:
        from .report import write_report
        write_report(path, report)
    print_result(json.dumps({
        "version": identity.version, "experiment": identity.experiment, "runs": len(requests), "made": counts.made,
        "missing": missing - counts.made, "incomplete": counts.incomplete, "controllers_failed": counts.controllers_failed, "csv": path,
        "report": report, "wall_s": round(wall_s, 3), "runs_per_s": round(counts.made / wall_s, 2) if wall_s else 0.0}))
    if is_interrupted:
        return interrupted()
    return STOPPED if counts.incomplete else CONTROLLER_FAILED if counts.controllers_failed else FINISHED

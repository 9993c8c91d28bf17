"""Classic swarm experiments: the trend of a paper must appear for the seeds, and must vanish without the mechanism."""

import concurrent.futures
import itertools
import os
import pathlib
import tempfile
from typing import Callable, NamedTuple

from table import run

SEEDS = range(1, 21)
ENOUGH = 19  # least number of seeds for which the trend must hold
TAU = 0.6    # it holds for a seed if Kendall's tau of values and metric, times the direction, is above this


def nothing(_):
    return []


class Classic(NamedTuple):
    experiment: str             # of `swarmanoid run`
    paper: str
    parameter: str              # meaning of the values, in words
    values: tuple               # at least four
    metric: str                 # of the run's results
    direction: int              # 1: the metric rises with the values; -1: it falls
    control: list               # PATH=VALUE of --set: without the mechanism
    control_value: object       # the value for the control
    failed: Callable            # whether the control failed, from the metrics of the control and, for equal seed and value, of the mechanism
    failed_words: str
    control_metric: str = ""           # metric by which the control fails, if not `metric`
    overrides: Callable = nothing      # of a value: PATH=VALUE of --set
    interventions: Callable = nothing  # of a value: elements of a file of interventions


def dead_wheels(count):
    """Interventions: the motors of the first `count` robots fail at the start."""
    return [f'<fault tick="0" robot="fb_{i}" device="footbot_wheels"><error kind="dead"/></fault>'
            for i in range(1, count + 1)]


EXPERIMENTS = (
    Classic("aggregation", "Gauci et al. 2014",
            "range of the sensor, m", (0.25, 0.75, 1.5, 3), "dispersion.second_moment", -1,
            overrides=lambda metres: [f"controllers.ac.sensors.footbot_camera.range={metres}"],
            control=["controllers.ac.parameters.color=black"], control_value=3,
            failed=lambda control, seen: control > 5 * seen, failed_words="robots that see nobody: over five times as much"),
    Classic("emergent_taxis", "Bjerknes and Winfield 2010",
            "robots of ten whose motors failed", (0, 1, 2, 4), "taxis.progress", -1,
            interventions=dead_wheels,
            control=["arena.beacon.intensity=0"], control_value=0,
            failed=lambda control, seen: control < seen / 2, failed_words="without light: less than half"),
    Classic("flocking", "Turgut et al. 2008", "noise of headings, rad", (0.5, 1.5, 2.25, 2.5, 2.75), "flock.mean_order", -1,
            overrides=lambda noise: [f"controllers.fc.sensors.footbot_camera.heading_noise.half_width={noise}"],
            control=["controllers.fc.parameters.alignment=false"], control_value=0.5,
            failed=lambda control, seen: control < seen / 2, failed_words="without alignment: less than half"),
    Classic("chain_formation", "Nouyan and Dorigo 2006", "distance from nest to prey, m", (1.4, 2.2, 3.0, 3.8),
            "path.formation_time", 1,
            overrides=lambda metres: [f"arena.prey.position={0.4 + metres:.1f}, 1, 0"],
            control=["controllers.cc.parameters.joining=0"], control_value=2.2,
            failed=lambda control, seen: control >= 1200 > seen, failed_words="without links: no path in 1200 s"),
    Classic("battery_foraging", "Lerman and Galstyan 2002", "robots", (2, 4, 8, 16, 32), "foraging.preys_per_kilojoule", -1,
            overrides=lambda robots: [f"arena.distribute.quantity={robots}"],
            control=["controllers.fc.parameters.little=0"], control_value=4, control_metric="foraging.preys",
            failed=lambda control, seen: control < seen / 2, failed_words="never going to charge: less than half the preys"),
)


def kendall(values):
    """@return Kendall's tau between indices and values; ties count neither as concordant nor as discordant"""
    pairs = list(itertools.combinations(values, 2))
    return sum((later > earlier) - (later < earlier) for earlier, later in pairs) / len(pairs)


def metrics_of(classic, seed, value, control=()):
    arguments = [part for override in [*classic.overrides(value), *control] for part in ("--set", override)]
    elements = classic.interventions(value)
    with tempfile.TemporaryDirectory() as folder:
        if elements:
            file = pathlib.Path(folder) / "interventions.xml"
            file.write_text(f"<interventions>{''.join(elements)}</interventions>")
            arguments += ["--interventions", file]
        return run(classic.experiment, "--seed", seed, *arguments)["metrics"]


def classic(table):
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for each in EXPERIMENTS:
            jobs = {(seed, value): pool.submit(metrics_of, each, seed, value) for seed in SEEDS for value in each.values}
            controls = [pool.submit(metrics_of, each, seed, each.control_value, each.control) for seed in SEEDS]
            found = {key: job.result() for key, job in jobs.items()}
            held = sum(each.direction * kendall([found[seed, value][each.metric] for value in each.values]) > TAU
                       for seed in SEEDS)
            judged = each.control_metric or each.metric
            without = [control.result()[judged] for control in controls]
            failed = sum(each.failed(control, found[seed, each.control_value][judged])
                         for seed, control in zip(SEEDS, without))
            means = [sum(found[seed, value][each.metric] for seed in SEEDS) / len(SEEDS) for value in each.values]
            words = ", ".join(f"{value}: {mean:.2f}" for value, mean in zip(each.values, means))
            table.add(f"`{each.experiment}` ({each.paper}): {each.metric} by {each.parameter}",
                      f"{'rises' if each.direction > 0 else 'falls'} (tau over {TAU}), {ENOUGH} of {len(SEEDS)} seeds; "
                      f"{each.failed_words}, {ENOUGH} of {len(SEEDS)}",
                      f"{held} of {len(SEEDS)}, means {words}; {failed} of {len(SEEDS)}, mean {judged} "
                      f"{sum(without) / len(SEEDS):.2f}", held >= ENOUGH and failed >= ENOUGH)

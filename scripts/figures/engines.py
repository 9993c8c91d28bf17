"""Figures of the engines: one experiment in each of them, and dynamics against the libraries alone."""

import itertools
import json
import os
import pathlib
import subprocess
import sys
import tempfile

from long_tests import last_word
from table import ROOT, run

SEEDS = range(1, 101)
GROUND = """<kinematics2d id="ground">
      <distance>0</distance>
    </kinematics2d>"""
SKY = """<kinematics2d id="sky">
      <distance>2</distance>
    </kinematics2d>"""
ENGINES = {
    "ground": {"kinematics2d": GROUND,
               "dynamics2d": '<dynamics2d id="ground"><subclock>4</subclock></dynamics2d>',
               "dynamics3d": '<dynamics3d id="ground"><subclock>10</subclock></dynamics3d>'},
    "sky": {"kinematics2d": SKY, "dynamics3d": '<dynamics3d id="sky"><subclock>10</subclock></dynamics3d>'},
}


def known_engines():
    listed = subprocess.run(["swarmanoid", "list", "engine"], capture_output=True, text=True, check=True).stdout
    return {line.split()[0].rstrip(':') for line in listed.splitlines() if line.strip()}


def mappings(table):
    """The retrieval experiment in each mapping of robots to engines, otherwise unchanged."""
    text = (ROOT / "src/swarmanoid_experiments/experiments/object_retrieval.xml").read_text()
    known = known_engines()
    for ground, sky in itertools.product(ENGINES["ground"], ENGINES["sky"]):
        what = f"object retrieval, footbots in {ground}, eyebot in {sky}, seeds 1-100"
        if not {ground, sky} <= known:
            table.add(what, "at least 95", "no such engine yet", False)
            continue
        mapped = text.replace(GROUND, ENGINES["ground"][ground]).replace(SKY, ENGINES["sky"][sky])
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "mapped.xml"
            file.write_text(mapped)
            runs = []
            for seed in SEEDS:
                print(f"\r{ground} / {sky}: seed {seed}", end="", file=sys.stderr, flush=True)
                done = subprocess.run(["swarmanoid", "run", file, "--seed", str(seed), "--quiet"], capture_output=True,
                                      text=True)
                if done.returncode != 0:
                    break
                runs.append(json.loads(done.stdout))
            print(file=sys.stderr)
        good = sum(bool(r["success"]) for r in runs)
        speed = sum(r["ticks"] for r in runs) / sum(r["wall_s"] for r in runs) if runs else 0.0
        seen = f"{good}; {speed:,.0f} ticks/s" if len(runs) == len(SEEDS) else done.stderr.strip().splitlines()[-1]
        table.add(what, "at least 95", seen, good >= 95)


def cooperation(table):
    """Tasks that only several robots together can do."""
    for experiment, what in (("group_pull", "ten footbots pull a prey that is too heavy for one, dynamics2d"),
                             ("gap", "a chain of five footbots over a gap that one falls into, dynamics3d")):
        good = 0
        for seed in SEEDS:
            print(f"\r{experiment}: seed {seed}", end="", file=sys.stderr, flush=True)
            good += bool(run(experiment, "--seed", seed)["success"])
        print(file=sys.stderr)
        table.add(f"{experiment}: {what}, seeds 1-100", "at least 95", str(good), good >= 95)


def dynamics2d(table, build):
    """Ticks of diffusion interleaved with Box2D alone, in one run, and the start time of a run."""
    binary = build / "devel/lib/swarmanoid_engines/swarmanoid_engines_dynamics2d_benchmark"
    done = subprocess.run([binary, "--benchmark_format=json"], capture_output=True, text=True, check=True)
    least = {(10, 4): 450, (1000, 4): 450, (10000, 4): 300, (10000, 10): 119}
    for entry in json.loads(done.stdout)["benchmarks"]:
        name, *sizes = entry["name"].split("/")
        robots, *subclock = (int(size.split(":")[1]) for size in sizes if ":" in size)
        if name == "BM_Start":
            seconds = entry["cpu_time"] / 1e3
            table.add(f"dynamics2d, diffusion: start of {robots:,} footbots, first tick included",
                      "at most 0.5 s" if robots == 20000 else "reported", f"{seconds:.2f} s",
                      seconds <= 0.5 if robots == 20000 else None)
            continue
        speed, disc, both = (entry[key] / 1e3 for key in ("items_per_second", "disc", "disc_and_box"))
        promised = least.get((robots, subclock[0]))
        is_good = promised is None or speed >= promised
        limit = f"at least {promised} thousand" if promised else "reported"
        if (robots, subclock[0]) == (10000, 4):
            limit += ", and as many as Box2D alone with a disc and a box"
            is_good = is_good and speed >= both
        table.add(f"dynamics2d, diffusion, {robots:,} footbots, {subclock[0]} steps a tick, first 100 ticks, robots x ticks/s", limit,
                  f"{speed:,.0f} thousand; Box2D alone {both:,.0f} with a disc and a box a robot, {disc:,.0f} with a disc",
                  is_good if promised else None)


def dynamics3d(table, build):
    """Ticks of diffusion interleaved with ODE alone, in one run."""
    binary = build / "devel/lib/swarmanoid_engines/swarmanoid_engines_dynamics3d_benchmark"
    done = subprocess.run([binary, "--benchmark_format=json"], capture_output=True, text=True, check=True)
    for entry in json.loads(done.stdout)["benchmarks"]:
        robots, subclock = (int(part.split(":")[1]) for part in entry["name"].split("/")[1:3])
        speed, exact, quick = (entry[key] / 1e3 for key in ("items_per_second", "exact", "quick"))
        is_promised = subclock == 10
        table.add(f"dynamics3d, diffusion, {robots:,} footbots, {subclock} steps a tick, first 50 ticks, robots x ticks/s",
                  "at least 30 thousand, and 0.9 of ODE alone" if is_promised else "reported",
                  f"{speed:,.0f} thousand; ODE alone, chassis and two wheels, {exact:,.0f} with its exact solver, {quick:,.0f} with the "
                  "quick one", speed >= max(30, 0.9 * exact, 0.9 * quick) if is_promised else None)


def crowd(file, kinematic, dynamic):
    """Diffusion with some footbots in kinematics2d and some in dynamics3d, in separate areas."""
    def group(name, count, low, high):
        return (f'<distribute quantity="{count}" layout="uniform"><minimum>{low},{low},0</minimum><maximum>{high},{high},0'
                f'</maximum><max_trials>100000</max_trials><footbot id="{name}"><controller>dc</controller></footbot>'
                "</distribute>") if count else ""

    def mapping(engine, name, count):
        return f'<engine id="{engine}"><entity id="{name}"/></engine>' if count else ""

    file.write_text(
        "<ahss-config><framework><clocktick>100</clocktick><maxclock>300</maxclock></framework><controllers>"
        '<diffusion id="dc" library="diffusion"><actuators><footbot_wheels/></actuators><sensors><footbot_proximity/>'
        '</sensors></diffusion></controllers><arena size="50,50,1" optimization="2D" bounded="true">'
        + group("kb", kinematic, 5, 45) + group("db", dynamic, 0.3, 4) + '</arena><engines><kinematics2d id="flat"/>'
        '<dynamics3d id="rough"><subclock>10</subclock></dynamics3d></engines><arena_physics>'
        + mapping("flat", "kb", kinematic) + mapping("rough", "db", dynamic) + "</arena_physics></ahss-config>")


def mixed(table):
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "mixed.xml"
        sizes = {"mixed": (1000, 10), "kinematic": (1000, 0), "dynamic": (0, 10)}
        times = {name: [] for name in sizes}
        for _ in range(5):
            for name, (kinematic, dynamic) in sizes.items():
                crowd(file, kinematic, dynamic)
                times[name].append(run(file)["wall_s"])
        best = {name: min(seconds) for name, seconds in times.items()}
        ratio = best["mixed"] / (best["kinematic"] + best["dynamic"])
        table.add("1,000 footbots in kinematics2d and 10 in dynamics3d, against the two runs apart", "at most 1.10",
                  f"{ratio:.2f}", ratio <= 1.1)


def oracles(table, build):
    """Tests that compare an engine with physics."""
    environment = dict(os.environ, SWARMANOID_LONG_TESTS="1")
    for engine, test, what, figure in (
            ("dynamics2d", "motion", "0.1 m/s for 10 s, an arc and a turn on the spot, subclock 1 to 50, up to 50 m from the origin",
             "1 mm; 1 %"),
            ("dynamics2d", "force", "pushing force and slip limit of a footbot", "5 % below and above the limit"),
            ("dynamics2d", "gripping", "grips: chains, ten pull what one cannot, tearing", "tear at the stated force within 5 %"),
            ("dynamics2d", "crowd", "a crowd in a box: command steps, grips torn, a mirror put upon them, 10^6 ticks",
             "speeds bounded, nobody through a wall; equal bits on repeat"),
            ("dynamics2d", "collision", "collisions: momentum and energy; walls, mirrors",
             "momentum 1e-6, energy 0.1 %"),
            ("dynamics3d", "driving", "0.1 m/s for 10 s, arcs and turns, ramps and steps; iterative solver",
             "5 mm along and across, 0.5 degrees; 1 %"),
            ("dynamics3d", "mechanics", "slopes along and across the axes, thrown bodies, momentum, energy",
             "friction angle within 3 %"),
            ("dynamics3d", "gap", "a chain of five footbots over a gap that one falls into", "works"),
            ("dynamics3d", "pushing", "pushing force and slip limit of a footbot", "5 % below and above the limit"),
            ("dynamics3d", "gripping", "grips: chains, ten pull what one cannot, breaking under a load",
             "breaks at the stated force within 5 %"),
            ("dynamics2d", "turret", "turrets: a heavy load turns the chassis, torque limit, passive",
             "angles within 1 %; slips within 5 % of the computed torque"),
            ("dynamics3d", "turret", "turrets: a heavy load turns the chassis, torque limit, passive",
             "angles within 1 %; slips within 5 % of the computed torque"),
            ("dynamics3d", "rough_ground", "a heightfield: slopes of friction, driving, climbing, holes, a crowd of 8 for 2,000 ticks",
             "friction angle within 3 %; 5 mm and 0.5 degrees in 1 m; pitch within 1 degree"),
            ("dynamics3d", "rope", "the rope: pendulum, tension of a hanging handbot, winding, tearing",
             "period and weight within 1 %; tears within 5 %"),
            ("dynamics3d", "arms", "arms under load, suction of hands, magnets of eyebots", "come off within 5 % of the stated force"),
            ("dynamics3d", "flight", "hover, steps, landing, bumps", "height within 2 cm"),
            ("dynamics3d", "endurance", "four footbots, two preys, an eyebot, a mirror put upon them, grips torn, 10^6 ticks",
             "speeds bounded, no NaN, nobody through a wall; equal bits on repeat"),
            ("dynamics2d", "approach", "wall, corners, prey, robot, head-on, 0.05 to 0.3 m/s, ticks of 10 to 200 ms",
             "contact within 1 mm, no overlap over 0.6 mm, free again"),
            ("dynamics2d", "impact", "eyebots at 3 m/s in ticks of 200 ms, thin walls, grips at walls, a jam",
             "nothing passes through; rest within 0.2 mm"),
            ("dynamics2d", "friction", "slip of treels in 16 directions, alone and in contact",
             "force opposes slip within 1 degree, size within 3 %"),
            ("dynamics2d", "pushing", "blocks off their middle, a disc, loads on turrets, 1 to 12 footbots at 0.7 to 1.4 of their limit, steps of 5 to 100 ms",
             "5 % of the angle, 6 % of the way computed by hand; 3 mm/s"),
            ("dynamics2d", "isotropy", "two footbots that push head on for 12 s, moved, turned, mirrored; upright planes; a crowd begun anew",
             "equal within 1e-6 m"),
            ("dynamics3d", "drive_load", "friction that a robot's own drive loads: along and into walls, squeezed blocks, a disc",
             "3 % of the speed; stands within 1 mm and 0.5 degrees; 3 degrees in 10 s where it backs in 1 degree askew"),
            ("dynamics3d", "friction", "slip of treels in 16 directions, slopes, a smooth wall, what is thrown",
             "force opposes slip within 1 degree, size within 3 %"),
            ("dynamics3d", "isotropy", "24 headings of a pushed prey; five experiments turned by 17, 37, 61 degrees; toppling",
             "1 mm in 0.5 m; equal within 2 mm after 20 s; topples within 3 % of the angle"),
            ("dynamics3d", "arm_limits", "any command to any joint of a handbot, at, near, beyond its limits",
             "rests within 1 % of the limit, 1.05 of max_speed never exceeded"),
            ("dynamics3d", "swing", "swinging handbots, two lengths and amplitudes, steps of 10 ms, 40 s",
             "energy at least 0.95, at most 1.01"),
            ("dynamics3d", "grip_start", "grips closed in the first tick", "tear at the stated force within 5 %"),
            ("dynamics3d", "crowd", "crowds, what was put into each other, command steps", "speeds bounded, no NaN")):
        file = build / f"devel/lib/swarmanoid_engines/swarmanoid_engines_{engine}_{test}_test"
        done = subprocess.run([file], capture_output=True, text=True, env=environment)
        table.add(f"{engine}: {what}", figure, last_word(done.stdout), done.returncode == 0)
    for package, test, what, figure in (
            ("devices", "led_visibility", "8 lit robots around one camera, 12 LEDs each; from above; at any tilt",
             "all 8 seen, each LED exactly where the own body does not hide it"),
            ("experiments", "models_page", "the formulas of the page of models, each against the simulator",
             "as the page says"),
            ("experiments", "handover_engines", "a footbot with a prey through kinematics2d, dynamics2d and dynamics3d, 1,000 handovers at speed",
             "pose and twist kept to the bit, grip and course kept, equal hash on repeat"),
            ("experiments", "climbing", "a handbot carried by footbots in dynamics2d climbs in dynamics3d and brings a box; handed over while it hangs",
             "the box is down; pose, twist, joints, rope kept to the bit")):
        file = build / f"devel/lib/swarmanoid_{package}/swarmanoid_{package}_{test}_test"
        done = subprocess.run([file], capture_output=True, text=True, env=environment)
        table.add(what, figure, last_word(done.stdout), done.returncode == 0)


def climbing(table, build):
    """The experiments with a handbot over the seeds: number of seeds that bring the box down, also with a faulty sensor."""
    file = build / "devel/lib/swarmanoid_experiments/swarmanoid_experiments_climbing_seeds_test"
    done = subprocess.run([file], capture_output=True, text=True, env=dict(os.environ, SWARMANOID_LONG_TESTS="1"))
    counts = [line for line in done.stdout.splitlines() if line.endswith(" seeds")]
    table.add("a handbot climbs and brings a box down, alone and carried there, by what it senses, seeds 1-100; with stuck "
              "distance sensors, with a dead WiFi", "at least 95; none where the sensor is faulty",
              "; ".join(counts) or "did not run", done.returncode == 0)

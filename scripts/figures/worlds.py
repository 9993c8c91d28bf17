"""Figures of many worlds of one experiment (swarmanoid.Worlds)."""

from python_bindings import evaluate

# diffusion of footbots with 24 rays, one per 1.6 m2, by a policy in NumPy; the best of five rounds
MEASURE = """
import resource, time, numpy, swarmanoid
count, robots, threads, engine, steps = {count}, {robots}, {threads}, "{engine}", {steps}
side = max(1.0, (1.6 * robots) ** 0.5)
text = '''<ahss-config>
  <framework><clocktick>100</clocktick><maxclock>100000000</maxclock></framework>
  <controllers>
    <diffusion id="dc" library="diffusion"><actuators><footbot_wheels/></actuators><sensors><footbot_proximity/></sensors></diffusion>
  </controllers>
  <arena size="{{0}},{{0}},1" optimization="2D" bounded="true">
    <distribute quantity="{{1}}"><minimum>0.2,0.2,0</minimum><maximum>{{2}},{{2}},0</maximum><footbot id="fb"><controller>dc</controller></footbot>
    </distribute>
  </arena>
  <engines><{{3}} id="ground"/></engines>
  <arena_physics><engine id="ground"><entity id="fb"/></engine></arena_physics>
</ahss-config>'''.format(side, robots, side - 0.2, engine)
options = dict(text=text, observations=["footbot_proximity.value"], actions=["footbot_wheels.left", "footbot_wheels.right"])
if engine == "dynamics2d":
    options["overrides"] = {{"engines.ground.subclock": 4}}
worlds = swarmanoid.Worlds(count=count, threads=threads, **options)
rates = []
for _ in range(5):
    start = time.perf_counter()
    for _ in range(steps):
        near = worlds.observations.max(axis=2) > 0
        worlds.step(numpy.stack([numpy.where(near, -3.0, 4.0), numpy.where(near, 3.0, 4.0)], axis=2).astype(numpy.float32))
    rates.append(count * robots * steps / (time.perf_counter() - start))
memory = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024

def seconds(work, times=5):
    least = float("inf")
    for _ in range(times):
        start = time.perf_counter()
        work()
        least = min(least, (time.perf_counter() - start) / count)
    return least

one = worlds.snapshot(0)
print(repr((max(rates), memory, seconds(worlds.reset), seconds(lambda: [worlds.snapshot(world) for world in range(count)]),
            seconds(lambda: worlds.restore(one)))))
"""


# an Env of one world of ten footbots, with a reward in Python; the best of five rounds
ENV = """
import time, numpy
from swarmanoid.environments import make

def speed(robots):
    return numpy.hypot(robots.twists[:, 0], robots.twists[:, 1])

env = make("diffusion", reward=speed, ticks=1000000, overrides={"arena.distribute.quantity": 10, "arena.size": (4, 4, 1),
           "arena.distribute.minimum": (0.2, 0.2, 0), "arena.distribute.maximum": (3.8, 3.8, 0)})
seen, _ = env.reset(seed=3)
rates = []
for _ in range(5):
    start = time.perf_counter()
    for _ in range(4000):
        near = seen.max(axis=1) > 0
        seen = env.step(numpy.array([[4.0, 4.0], [-3.0, 3.0]])[near.astype(int)])[0]
    rates.append(10 * 4000 / (time.perf_counter() - start))
print(repr(max(rates)))
"""


def measure(count, robots, threads=1, engine="kinematics2d"):
    """@return agent steps/s, memory of the process [MB], seconds of a world's reset, of its snapshot, and of a restore"""
    steps = max(10, 500_000 // (count * robots))
    return evaluate(MEASURE.format(count=count, robots=robots, threads=threads, engine=engine, steps=steps))


def worlds(table):
    """Speed of many small swarms."""
    what = "worlds of diffusion, actions from NumPy each tick"
    rates = {}
    for count, robots, threads, engine, least in ((1000, 10, 1, "kinematics2d", 2.0), (1000, 10, 2, "kinematics2d", None),
                                                  (4000, 3, 1, "kinematics2d", 1.5), (100, 100, 1, "kinematics2d", 3.0),
                                                  (1, 10000, 1, "kinematics2d", 4.0), (1000, 10, 1, "dynamics2d", 0.5)):
        rate, memory, reset, snapshot, restore = measure(count, robots, threads, engine)
        rates[count, robots, threads, engine] = rate
        row = f"{what}: {count:,} x {robots:,} footbots, {engine}, {threads} thread{'s' if threads > 1 else ''}"
        if least is None:
            times = rate / rates[count, robots, 1, engine]
            table.add(row, "at least 1.8 times one thread", f"{times:.2f} times, {rate / 1e6:.2f} million agent steps/s", times >= 1.8)
        else:
            table.add(row, f"at least {least:g} million agent steps/s", f"{rate / 1e6:.2f} million agent steps/s", rate >= least * 1e6)
        if (count, robots, threads, engine) == (1000, 10, 1, "kinematics2d"):
            for name, found, most in (("reset", reset, 20e-6), ("snapshot", snapshot, 50e-6), ("restore", restore, 50e-6)):
                table.add(f"1,000 worlds x 10 footbots, kinematics2d: {name} of a world", f"under {1e6 * most:.0f} us",
                          f"{1e6 * found:.0f} us", found < most)
            table.add("1,000 worlds x 10 footbots, kinematics2d: memory of the process", "under 400 MB", f"{memory:.0f} MB", memory < 400)
    rate = evaluate(ENV)
    table.add("environments.Env of one world of diffusion, 10 footbots, reward in Python, kinematics2d", "at least 400 thousand agent steps/s",
              f"{rate / 1e3:.0f} thousand agent steps/s", rate >= 400e3)

#!/usr/bin/python3
# %% [markdown]
# # A swarm in Python
#
# Each cell, from `# %%` to the next, runs by itself in an editor that knows such cells (Spyder, VS Code, PyCharm); all of them are
# this script. Lengths are in metres, angles in radians, times in seconds.

# %% [markdown]
# ## A run and its contents

# %%
import math

import numpy
import swarmanoid

simulation = swarmanoid.Simulation("phototaxis", seed=3)      # four footbots, two lamps that are lit in turn
print(simulation.robots.names)
print(simulation.entities.types)

# %% [markdown]
# Get the robots anew after each tick: the arrays are copies of the state at that time.

# %%
track = []
for _ in range(70):                                           # the lamp in the west is lit for 40 s
    simulation.tick(5)                                        # half a second
    track.append(simulation.robots.poses[:, :2])              # x, y: (robots, 2)
track = numpy.array(track)                                    # (times, robots, 2)
lamp = simulation.entities.poses[simulation.entities.names.index("west"), :2]
distance = numpy.linalg.norm(track - lamp, axis=2)            # (times, robots)
print(f"mean distance from the lamp: {distance[0].mean():.1f} m, then {distance[-1].mean():.1f} m")
assert distance[-1].mean() < 0.6 * distance[0].mean()

# %% [markdown]
# Readings and commands of the robots are available under the names of devices and fields.

# %%
robots = simulation.robots
print(robots.readings.keys(), robots.commands.keys())
print(robots.readings["footbot_proximity"].value.shape)       # 24 sensors each
print(robots.commands["footbot_wheels"].left.round(1))        # rad/s

# %% [markdown]
# ## A controller of all robots at once
#
# A Braitenberg vehicle in a few lines of arrays: a wheel turns faster the nearer an obstacle is on its side, so robots turn away.

# %%
print({name: field["shape"] for name, field in swarmanoid.fields_of("footbot_wheels").items()})


class Follower:
    def step(self, robots):
        value = robots.readings["footbot_proximity"].value    # (robots, 24), counter-clockwise from ahead
        left, right = value[:, 1:7].sum(axis=1, dtype=float), value[:, 18:24].sum(axis=1, dtype=float)
        wheels = robots.commands["footbot_wheels"]
        wheels.left = 4.0 + 3.0 * (left - right)
        wheels.right = 4.0 - 3.0 * (left - right)


at_once = swarmanoid.Simulation("diffusion", seed=1, controllers={"dc": Follower()})
at_once.tick(100)

# %% [markdown]
# ## The same, one robot at a time
#
# A class makes a controller for each robot. It is slower, and it makes the same run, to the bit.

# %%
class FollowerAlone:
    def init(self, robot, parameters):
        self.proximity = robot.readings["footbot_proximity"]
        self.wheels = robot.commands["footbot_wheels"]

    def step(self, robot):
        value = self.proximity.value                          # (24,)
        left, right = value[1:7].sum(dtype=float), value[18:24].sum(dtype=float)
        self.wheels.left = 4.0 + 3.0 * (left - right)
        self.wheels.right = 4.0 - 3.0 * (left - right)


alone = swarmanoid.Simulation("diffusion", seed=1, controllers={"dc": FollowerAlone})
alone.tick(100)
print("the same run:", alone.state_hash == at_once.state_hash)
assert alone.state_hash == at_once.state_hash

# %% [markdown]
# ## A rule, and interventions
#
# A rule of the file switches the lamps of this world. This rule carries a robot back that has reached the lamp, and counts.

# %%
class CarryBack:
    def reset(self, world):
        self.carried = 0

    def after_tick(self, world):
        robots = world.robots
        distance = numpy.linalg.norm(robots.poses[:, :2] - [1.0, 1.5], axis=1)
        for place in numpy.flatnonzero(distance < 0.5):
            where = (world.uniform(3.5, 4.5), world.uniform(0.5, 2.5), 0)
            world.try_to(swarmanoid.Move(robots.names[place], where, heading=world.uniform(0, 2 * math.pi)))
            self.carried += 1

    def metrics(self):
        return {"carried": getattr(self, "carried", 0)}

    def finished(self):
        return self.carried >= 4


judged = swarmanoid.Simulation("phototaxis", seed=3, rules={"back": CarryBack()})
judged.apply(swarmanoid.SetProperty("west", "intensity", 100))
result = judged.run()
print(f"{result['metrics']['back.carried']:.0f} carried back in {judged.time:.0f} s of simulated time")
assert result["finished"]

# %% [markdown]
# ## Many runs
#
# Simulations of different threads run at the same time, and each is the run of its seed.

# %%
from concurrent.futures import ThreadPoolExecutor


def carried_after(seed):
    return swarmanoid.Simulation("phototaxis", seed=seed, rules={"back": CarryBack()}).run()["ticks"]


with ThreadPoolExecutor(2) as pool:
    ticks = list(pool.map(carried_after, range(1, 5)))
print("ticks until four were carried back:", ticks)
assert ticks == [carried_after(seed) for seed in range(1, 5)]

# %% [markdown]
# Complete descriptions are in docs/how-to/simulate_in_python.md; learning, in docs/how-to/train_in_python.md.

"""Swarms as environments for reinforcement learning, with the interfaces of Gymnasium's Env and VectorEnv and PettingZoo's
ParallelEnv.

Neither library is needed: spaces are classes of this module with the attributes of theirs. A step is one tick or several.
Observations are the readings that a controller gets in the next tick, and actions are applied in that tick, so a policy makes
the same run, bit for bit, as the same computation in a controller.

>>> def reward(robots):
...     return robots.twists[:, 0]                                # (agents,): speed along x [m/s]
>>> env = ParallelEnv("diffusion", reward=reward, observations=["footbot_proximity.value"],
...                   actions={"footbot_wheels.left": (-5, 5), "footbot_wheels.right": (-5, 5)},
...                   overrides={"arena.distribute.quantity": 3})
>>> observations, infos = env.reset(seed=4)
>>> env.agents
['fb_1', 'fb_2', 'fb_3']
>>> env.observation_space("fb_1")
Box(shape=(24,), dtype=float32)
>>> actions = {agent: [3.0, 3.0] for agent in env.agents}        # rad/s
>>> observations, rewards, terminations, truncations, infos = env.step(actions)
>>> observations["fb_1"].shape, terminations["fb_1"], truncations["fb_1"]
((24,), False, False)
"""

from ._env import Env, ParallelEnv
from ._spaces import Box, Discrete, MultiDiscrete
from ._tasks import make
from ._vector_env import AutoresetMode, Swarms, VectorEnv

__all__ = ["AutoresetMode", "Box", "Discrete", "Env", "MultiDiscrete", "ParallelEnv", "Swarms", "VectorEnv", "make"]

for _name in __all__:
    if globals()[_name].__module__.startswith("swarmanoid."):
        globals()[_name].__module__ = __name__   # the public module, for users and pickle
del _name

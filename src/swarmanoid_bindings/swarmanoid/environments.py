"""Swarms as environments for reinforcement learning, with the interfaces of Gymnasium's Env and PettingZoo's ParallelEnv.

Neither library is needed: spaces are a Box of this module with the attributes of theirs. A step is one tick or several.
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

import numpy

from ._core import Simulation, fields_of


class Box:
    """A space of arrays of one shape, with bounds for each number."""

    def __init__(self, low, high, dtype=numpy.float32, seed=None):
        """@param low, high arrays of the same shape"""
        self.dtype = numpy.dtype(dtype)
        self.low, self.high = numpy.asarray(low, self.dtype), numpy.asarray(high, self.dtype)
        if self.low.shape != self.high.shape or not (self.low <= self.high).all():
            raise ValueError(f"found bounds from {low!r} to {high!r}, allowed: of one shape, none above the other")
        self.shape = self.low.shape
        self.seed(seed)

    def seed(self, seed=None):
        """Seeds the random numbers of samples."""
        self._random = numpy.random.default_rng(seed)
        return [seed]

    def sample(self):
        """Random numbers: uniform between two bounds, half-normal from a single bound, normal about 0 without bounds."""
        bounded = numpy.isfinite(self.low) & numpy.isfinite(self.high)
        low = numpy.where(bounded, self.low, 0).astype(float)
        uniform = self._random.uniform(low, numpy.where(bounded, self.high, 1).astype(float))
        distance = self._random.normal(size=self.shape)
        free = numpy.where(numpy.isfinite(self.low), self.low + abs(distance),
                           numpy.where(numpy.isfinite(self.high), self.high - abs(distance), distance))
        return numpy.where(bounded, uniform, free).astype(self.dtype)

    def contains(self, value):
        array = numpy.asarray(value)
        return bool(array.shape == self.shape and numpy.can_cast(array.dtype, self.dtype, "same_kind")
                    and (array >= self.low).all() and (array <= self.high).all())

    __contains__ = contains

    def is_bounded(self, manner="both"):
        below, above = numpy.isfinite(self.low).all(), numpy.isfinite(self.high).all()
        return bool({"both": below and above, "below": below, "above": above}[manner])

    def __eq__(self, other):
        return (isinstance(other, Box) and self.dtype == other.dtype and numpy.array_equal(self.low, other.low)
                and numpy.array_equal(self.high, other.high))

    def __repr__(self):
        return f"Box(shape={self.shape}, dtype={self.dtype})"


class Fields:
    """Fields of devices, concatenated to one row of numbers per robot."""

    def __init__(self, fields):
        """@param fields names such as "footbot_proximity.value", or a dictionary of these with (low, high)"""
        bounds = fields if isinstance(fields, dict) else dict.fromkeys(fields)
        self.parts = []   # device, path in it, first and last index in the row, shape for one robot
        low, high = [], []
        for name, given in bounds.items():
            device, _, field = name.partition(".")
            known = fields_of(device)
            if field not in known:
                raise ValueError(f"found the field '{name}', allowed: {', '.join(f'{device}.{each}' for each in known)}")
            shape = known[field]["shape"]
            size = int(numpy.prod(shape))
            self.parts.append((device, field.split("."), len(low), len(low) + size, shape))
            least, most = given or (known[field]["low"], known[field]["high"])
            low += [least] * size
            high += [most] * size
        if not self.parts:
            raise ValueError("found no fields, allowed: one or more, such as 'footbot_proximity.value'")
        self.low, self.high = numpy.array(low, float), numpy.array(high, float)
        self.size = len(low)

    def read(self, devices, count):
        """@return (count, size), float32"""
        line = numpy.empty((count, self.size), numpy.float32)
        for device, path, first, last, _ in self.parts:
            value = devices[device]
            for word in path:
                value = getattr(value, word)
            line[:, first:last] = value.reshape(count, -1)
        return line

    def write(self, devices, line):
        for device, path, first, last, shape in self.parts:
            target = devices[device]
            for word in path[:-1]:
                target = getattr(target, word)
            setattr(target, path[-1], line[:, first:last].reshape(len(line), *shape))


def agree(reward, count):
    """@return rewards of the shape (count,), float64"""
    rewards = numpy.asarray(reward, float)
    if rewards.shape not in ((), (count,)):
        raise ValueError(f"reward: found the shape {rewards.shape}, allowed: a number, or ({count},)")
    return numpy.broadcast_to(rewards, (count,))


class Env:
    """A swarm as one agent that observes and commands all of its robots: the interface of gymnasium.Env.

    observation_space and action_space have the shape (robots, numbers): a row per robot with the controller, in the order of
    `names`. Rows of deleted and stopped robots are 0. The reward is the sum over all robots."""

    metadata = {"render_modes": []}
    render_mode = None
    spec = None

    def __init__(self, experiment=None, *, reward, observations, actions, controller=None, ticks_per_step=1, **options):
        """@param reward a function of the remaining robots, in their order, called after a step: a number, or one per robot
        @param observations, actions fields of sensors and actuators, ["footbot_proximity.value"]; a dictionary has
        (low, high) for each, otherwise the device's bounds apply
        @param controller id of the configuration of the agents' robots; optional if there is only one
        @param options of Simulation"""
        self._reward = reward
        self._observed, self._commanded = Fields(observations), Fields(actions)
        if int(ticks_per_step) != ticks_per_step or ticks_per_step < 1:
            raise ValueError(f"ticks_per_step: found {ticks_per_step}, allowed: a whole number from 1")
        self._ticks = int(ticks_per_step)
        self._actions = None
        controller = controller or self._only_controller(experiment, options)
        self.simulation = Simulation(experiment, controllers={controller: self._act}, **options)
        robots = self.simulation.robots
        self._controller = controller
        self._take_robots(robots)
        count = len(self.names)
        self.observation_space = self._space(self._observed, count)
        self.action_space = self._space(self._commanded, count)

    @staticmethod
    def _only_controller(experiment, options):
        # without a folder: otherwise files would exist already when the run itself begins
        known = sorted(set(Simulation(experiment, **{**options, "out": None}).robots.controllers) - {""})
        if len(known) != 1:
            raise ValueError(f"controller: found none, allowed: {', '.join(known)}")
        return known[0]

    @staticmethod
    def _space(fields, count):
        return Box(numpy.tile(fields.low, (count, 1)), numpy.tile(fields.high, (count, 1)))

    def _take_robots(self, robots):
        mine = [place for place, controller in enumerate(robots.controllers) if controller == self._controller]
        self.names = [robots.names[place] for place in mine]
        self._numbers = robots.numbers[mine]
        self._stepped = self._numbers

    def _act(self, robots):
        """The controller of the simulation: applies the actions of the last step."""
        self._stepped = robots.numbers
        if self._actions is not None:
            places = numpy.searchsorted(self._numbers, self._stepped)
            known = (places < len(self._numbers)) & (self._numbers[numpy.minimum(places, len(self._numbers) - 1)] == self._stepped)
            if not known.all():
                raise RuntimeError(f"found the robots {robots.names}, allowed: those of the start, {self.names}")
            self._commanded.write(robots.commands, self._actions[places])

    def _look(self):
        """@return remaining robots, their indices among all robots, and the observations of all robots"""
        self.simulation.sense()
        robots = self.simulation.robots
        left = numpy.flatnonzero(numpy.isin(robots.numbers, self._stepped))
        present = robots.take(left)
        places = numpy.searchsorted(self._numbers, present.numbers)
        observations = numpy.zeros((len(self.names), self._observed.size), numpy.float32)
        if len(places) > 0:
            observations[places] = self._observed.read(present.readings, len(places))
        return present, places, observations

    def reset(self, *, seed=None, options=None):
        """Starts a run. Without a seed it takes the seed of the last run plus 1, so that runs differ.
        @return observations (robots, numbers), and a dictionary"""
        self._actions = None
        self.simulation.reset(self.simulation.seed + 1 if seed is None else seed)
        self._take_robots(self.simulation.robots)
        if seed is not None:
            self.action_space.seed(seed)
            self.observation_space.seed(seed)
        return self._look()[2], self._info()

    def _info(self):
        return {"ticks": self.simulation.ticks, **self.simulation.metrics}

    def advance(self, actions):
        """Same as `step`, with results per robot. @return observations (robots, numbers), rewards (robots,), whether each robot
        remains (robots,), terminated, truncated, info"""
        given = numpy.asarray(actions, numpy.float64)
        if given.shape != self.action_space.shape:
            raise ValueError(f"actions: found the shape {given.shape}, allowed: {self.action_space.shape}")
        self._actions = given
        self.simulation.tick(self._ticks)
        present, places, observations = self._look()
        rewards, left = numpy.zeros(len(self.names)), numpy.zeros(len(self.names), bool)
        left[places] = True
        rewards[places] = agree(self._reward(present), len(places))
        truncated = self.simulation.ticks >= self.simulation.max_ticks
        terminated = (self.simulation.finished and not truncated) or not left.any()
        return observations, rewards, left, bool(terminated), bool(truncated), self._info()

    def step(self, action):
        """@param action (robots, numbers) @return observations, reward, terminated (a rule has ended the run, or no robot
        remains), truncated (the last tick of the run was made), info: ticks and metrics"""
        observations, rewards, _, terminated, truncated, info = self.advance(action)
        return observations, float(rewards.sum()), terminated, truncated, info

    def render(self):
        """There is nothing to see: the program and rviz show runs."""

    def close(self):
        self.simulation.close()

    @property
    def unwrapped(self):
        return self

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()


class ParallelEnv:
    """A swarm with one agent per robot: the interface of pettingzoo.ParallelEnv. Keys of dictionaries are names of robots.

    An agent whose robot was deleted or has stopped is terminated in that step and then removed from `agents`."""

    metadata = {"name": "swarmanoid", "render_modes": []}
    render_mode = None

    def __init__(self, experiment=None, **options):
        """@param options same as of Env"""
        self._env = Env(experiment, **options)
        self.possible_agents = list(self._env.names)
        self.agents = []
        fields = self._env._observed, self._env._commanded
        self._observation_spaces, self._action_spaces = ({agent: Box(each.low, each.high) for agent in self.possible_agents}
                                                         for each in fields)

    simulation = property(lambda self: self._env.simulation)
    observation_spaces = property(lambda self: dict(self._observation_spaces))
    action_spaces = property(lambda self: dict(self._action_spaces))
    num_agents = property(lambda self: len(self.agents))
    max_num_agents = property(lambda self: len(self.possible_agents))
    unwrapped = property(lambda self: self)

    def observation_space(self, agent):
        """A space of the shape (numbers,); the same object each time."""
        return self._observation_spaces[agent]

    def action_space(self, agent):
        return self._action_spaces[agent]

    def reset(self, seed=None, options=None):
        """@return observations and infos by agent"""
        observations, info = self._env.reset(seed=seed)
        self.agents = list(self.possible_agents)
        return dict(zip(self.agents, observations)), {agent: dict(info) for agent in self.agents}

    def step(self, actions):
        """@param actions (numbers,) by agent, for each remaining agent
        @return observations, rewards, terminations, truncations, infos, all by agent"""
        missing = [agent for agent in self.agents if agent not in actions]
        if missing or len(actions) != len(self.agents):
            raise ValueError(f"actions: found those of {', '.join(actions)}, allowed: of {', '.join(self.agents)}")
        line = numpy.zeros((len(self.possible_agents), self._env._commanded.size))
        places = {agent: place for place, agent in enumerate(self.possible_agents)}
        for agent, action in actions.items():
            line[places[agent]] = action
        observations, rewards, left, terminated, truncated, info = self._env.advance(line)
        before = self.agents
        at = [places[agent] for agent in before]
        terminations = {agent: bool(terminated or not left[place]) for agent, place in zip(before, at)}
        truncations = dict.fromkeys(before, truncated)
        self.agents = [] if terminated or truncated else [agent for agent in before if not terminations[agent]]
        return ({agent: observations[place] for agent, place in zip(before, at)},
                {agent: float(rewards[place]) for agent, place in zip(before, at)}, terminations, truncations,
                {agent: dict(info) for agent in before})

    def state(self):
        """All observations: (possible agents, numbers)."""
        return self._env._look()[2]

    def render(self):
        """There is nothing to see: the program and rviz show runs."""

    def close(self):
        self._env.close()

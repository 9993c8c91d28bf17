"""Environments of one world: a swarm as one agent, and as one agent per robot."""

import numpy

from ._core import AgentWorld
from ._spaces import Actions, Fields


def total(reward, count):
    """The sum of rewards of robots. @param reward a number for each, or (count,)"""
    rewards = numpy.asarray(reward, float)
    if rewards.shape == ():
        return float(rewards) * count
    if rewards.shape != (count,):
        raise ValueError(f"reward: found the shape {rewards.shape}, allowed: a number, or ({count},)")
    return float(rewards.sum())


def whole(name, value):
    """A whole number from 1. @throws ValueError"""
    if int(value) != value or value < 1:
        raise ValueError(f"{name}: found {value}, allowed: a whole number from 1")
    return int(value)


def signed(reward):
    """The sign and the name of a metric that rewards: "-lamps.distance" rewards its fall."""
    return (-1.0, reward[1:]) if reward.startswith("-") else (1.0, reward)


def metric_of(info, reward):
    """A metric that rewards, with its sign. @throws ValueError if there is none of that name, or if it is no number"""
    sign, name = signed(reward)
    if isinstance(info.get(name), (bool, float)):
        return sign * float(info[name])
    known = [each for each, value in info.items() if isinstance(value, (bool, float))]
    raise ValueError(f"reward: found the metric '{name}', allowed: {', '.join(known) or 'none, without rules'}")


def mode_of_pictures(given):
    """@throws ValueError for another mode than "rgb_array" or None"""
    if given not in (None, "rgb_array"):
        raise ValueError(f"render_mode: found '{given}', allowed: rgb_array, None")
    return given


PICTURE = {"window_size": (640, 480)}


class Env:
    """A swarm as one agent that observes and commands all of its robots: the interface of gymnasium.Env.

    observation_space and action_space have the shape (robots, numbers): a row per robot with the controller, in the order of
    `names`. Rows of deleted and stopped robots are 0. The reward is the sum over all robots."""

    metadata = {"render_modes": ["rgb_array"]}
    spec = None

    def __init__(self, experiment=None, *, reward, observations, actions, choices=None, controller=None, ticks_per_step=1,
                 render_mode=None, camera=None, **options):
        """@param reward a function of the remaining robots, in their order, called after a step: a number, or one per robot;
        or the name of a metric, whose rise in a step is the reward of each robot; behind a "-" its fall.
        The first step of a run has the reward 0 then: rules measure after ticks
        @param observations, actions fields of sensors and actuators, ["footbot_proximity.value"]; a dictionary has
        (low, high) for each, otherwise the device's bounds apply. A field of a sensor's list is read by direction:
        "footbot_camera.blobs.distance[sectors=8 near maximum=3 colors=yellow,green]"
        @param choices vectors of the numbers of `actions`: an action is then the index of one of them for each robot
        @param controller id of the configuration of the agents' robots; optional if there is only one
        @param render_mode "rgb_array" for pictures by `render` @param camera parameters of the visualisation opengl_render
        @param options of Simulation"""
        self.render_mode, self._camera, self._pictures = mode_of_pictures(render_mode), camera or PICTURE, None
        self._reward = reward
        self._observed, self._commanded = Fields(observations, is_action=False), Actions(actions, choices)
        self._world = AgentWorld(self._observed.names, self._commanded.fields.names, controller,
                                 whole("ticks_per_step", ticks_per_step), experiment=experiment, **options)
        self.names = self._world.robots().names
        self.observation_space = self._observed.box(len(self.names))
        self.action_space = self._commanded.space(len(self.names))
        self._metric = None   # of the last step, if it rewards
        if isinstance(reward, str):
            metric_of(self._world.info(), reward)   # refuses an unknown one

    @property
    def simulation(self):
        """The simulation of the world, for metrics, robots and interventions. Ticks and resets that it makes itself count for
        the next step."""
        return self._world.simulation

    def reset(self, *, seed=None, options=None):
        """Starts a run. Without a seed it takes the seed of the last run plus 1, so that runs differ.
        @return observations (robots, numbers), and a dictionary"""
        self._world.reset(seed)
        self.names = self._world.robots().names
        if seed is not None:
            self.action_space.seed(seed)
            self.observation_space.seed(seed)
        self._metric = None
        return self._world.observations(), self._world.info()

    def _advance(self, actions):
        """@return observations, rewards of the remaining robots or one of each, how many remain, terminated, truncated, info"""
        observations, terminated, truncated = self._world.step(self._commanded.numbers(actions))
        info = self._world.info()
        if not isinstance(self._reward, str):
            robots = self._world.robots()
            return observations, self._reward(robots), len(robots), terminated, truncated, info
        before, self._metric = self._metric, metric_of(info, self._reward)
        return observations, 0.0 if before is None else self._metric - before, int(self._world.present().sum()), terminated, truncated, info

    def advance(self, actions):
        """Same as `step`, with results per robot. @return observations (robots, numbers), rewards (robots,), whether each robot
        remains (robots,), terminated, truncated, info"""
        observations, given, count, terminated, truncated, info = self._advance(actions)
        total(given, count)   # refuses a wrong shape
        left = self._world.present()
        rewards = numpy.zeros(len(left))
        rewards[left] = given
        return observations, rewards, left, terminated, truncated, info

    def step(self, action):
        """@param action (robots, numbers), or (robots,) with choices
        @return observations, reward, terminated (a rule has ended the run, or no robot remains), truncated (the last tick of
        the run was made), info: ticks and metrics"""
        observations, given, count, terminated, truncated, info = self._advance(action)
        return observations, total(given, count), terminated, truncated, info

    def state(self):
        """The whole world, for a critic: (robots and other movable entities, 14), a row for each robot in the order of `names`,
        then the others by entity number. A row has 1, position [m], orientation as a quaternion x, y, z, w, linear [m/s] and
        angular velocity [rad/s] in W, or only zeros for an entity that is gone."""
        return self._world.state()

    def render(self):
        """A picture of the world as it is, (height, width, 3), uint8, in the mode rgb_array; else None."""
        if self.render_mode is None:
            return None
        if self._pictures is None:
            self._pictures = self.simulation.pictures(self._camera)
        return self._pictures.take()

    def close(self):
        self._pictures = None
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

    metadata = {"name": "swarmanoid", "render_modes": ["rgb_array"]}

    def __init__(self, experiment=None, *, state="observations", **options):
        """@param state what `state` returns: "observations" of all agents, or the "world" as Env.state
        @param options same as of Env"""
        if state not in ("observations", "world"):
            raise ValueError(f"state: found '{state}', allowed: observations, world")
        self._knows_world = state == "world"
        self._env = Env(experiment, **options)
        self.possible_agents = list(self._env.names)
        self.agents = []
        self._places = {agent: place for place, agent in enumerate(self.possible_agents)}
        self._observation_spaces = {agent: self._env._observed.box() for agent in self.possible_agents}
        self._action_spaces = {agent: self._env._commanded.space() for agent in self.possible_agents}
        self._line = numpy.zeros(self._env.action_space.shape, self._env.action_space.dtype)

    simulation = property(lambda self: self._env.simulation)
    observation_spaces = property(lambda self: dict(self._observation_spaces))
    action_spaces = property(lambda self: dict(self._action_spaces))
    num_agents = property(lambda self: len(self.agents))
    max_num_agents = property(lambda self: len(self.possible_agents))
    unwrapped = property(lambda self: self)
    render_mode = property(lambda self: self._env.render_mode)

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
        """@param actions (numbers,) by agent, or with choices a whole number, for each remaining agent
        @return observations, rewards, terminations, truncations, infos, all by agent"""
        before = self.agents
        if len(actions) != len(before) or any(agent not in actions for agent in before):
            raise ValueError(f"actions: found those of {', '.join(actions)}, allowed: of {', '.join(before)}")
        line = numpy.zeros(self._line.shape, float if self._line.dtype.kind == "f" else self._line.dtype)
        for agent, action in actions.items():
            line[self._places[agent]] = action
        observations, rewards, left, terminated, truncated, info = self._env.advance(line)
        at = [self._places[agent] for agent in before]
        terminations = {agent: bool(terminated or not left[place]) for agent, place in zip(before, at)}
        self.agents = [] if terminated or truncated else [agent for agent in before if not terminations[agent]]
        return ({agent: observations[place] for agent, place in zip(before, at)},
                {agent: float(rewards[place]) for agent, place in zip(before, at)}, terminations,
                dict.fromkeys(before, truncated), {agent: dict(info) for agent in before})

    def state(self):
        """All observations, (possible agents, numbers), or the world as Env.state: see the constructor."""
        return self._env.state() if self._knows_world else self._env._world.observations()

    def render(self):
        """As of Env."""
        return self._env.render()

    def close(self):
        self._env.close()

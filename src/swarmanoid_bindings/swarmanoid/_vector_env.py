"""Many worlds as the interface of gymnasium.vector.VectorEnv."""

import enum
import functools

import numpy

from ._core import Worlds
from ._env import PICTURE, mode_of_pictures, signed
from ._spaces import Actions, Fields

try:
    from gymnasium.vector import AutoresetMode
except ImportError:
    class AutoresetMode(enum.Enum):
        """What happens to a world whose run is over, as Gymnasium names it."""

        NEXT_STEP = "NextStep"
        SAME_STEP = "SameStep"
        DISABLED = "Disabled"


class Swarms:
    """What a reward function of VectorEnv gets: all worlds after a step, as arrays. Rows of robots that are gone are 0."""

    def __init__(self, worlds, actions):
        """@param actions (worlds, robots, numbers) of the step"""
        self._worlds = worlds
        self.actions = actions

    @property
    def observations(self):
        """(worlds, robots, numbers), float32, of the next tick: read-only."""
        return _read_only(self._worlds.observations)

    @property
    def present(self):
        """(worlds, robots), bool: whether the robot is there and has not failed."""
        return _read_only(self._worlds.present)

    @functools.cached_property
    def poses(self):
        """(worlds, robots, 7): position [m] and orientation as a quaternion x, y, z, w, in W."""
        return self._worlds.poses

    @functools.cached_property
    def twists(self):
        """(worlds, robots, 6): linear [m/s] and angular velocity [rad/s], in W."""
        return self._worlds.twists


def _read_only(array):
    view = array.view()
    view.flags.writeable = False
    return view


def _mode(given):
    """@param given a mode of Gymnasium, "next_step" or "NextStep" """
    name = getattr(given, "name", str(given)).lower()
    for mode in AutoresetMode:
        if name in (mode.name.lower(), mode.value.lower()):
            return mode
    raise ValueError(f"autoreset_mode: found '{given}', allowed: {', '.join(mode.name.lower() for mode in AutoresetMode)}")


class VectorEnv:
    """Many worlds, each a swarm as one agent: the interface of gymnasium.vector.VectorEnv.

    Observations are (num_envs, robots, numbers), float32, and rewards (num_envs,), the sum over the robots of each world;
    `robot_rewards` has those of each robot. In a world the rows of robots that are gone are 0.

    A world that ends has its metrics in the dictionary of the step, with masks as Gymnasium has them: `info["rule.metric"]` where
    `info["_rule.metric"]`; in the mode same_step they are in `info["final_info"]`, beside `info["final_obs"]`.

    >>> env = VectorEnv("diffusion", 3, reward=lambda swarms: swarms.twists[:, :, 0], observations=["footbot_proximity.value"],
    ...                 actions={"footbot_wheels.left": (-5, 5), "footbot_wheels.right": (-5, 5)},
    ...                 overrides={"arena.distribute.quantity": 4})
    >>> observations, infos = env.reset(seed=7)
    >>> observations.shape, env.single_action_space
    ((3, 4, 24), Box(shape=(4, 2), dtype=float32))
    >>> observations, rewards, terminated, truncated, infos = env.step(env.action_space.sample())
    >>> rewards.shape, infos["ticks"].tolist(), infos["_ticks"].all()
    ((3,), [1, 1, 1], True)
    """

    spec = None
    closed = False

    def __init__(self, experiment=None, num_envs=1, *, reward, observations, actions, choices=None, controller=None,
                 ticks_per_step=1, autoreset_mode="next_step", render_mode=None, camera=None, **options):
        """@param reward a function of Swarms, called after a step, that returns (worlds, robots), or (worlds,) for the worlds as a
        whole; or the name of a metric, whose rise in a step is the reward of a world; behind a "-" its fall. The
        first step of a run has the reward 0 then: rules measure after ticks
        @param observations, actions, choices, controller, ticks_per_step, render_mode, camera as of Env
        @param autoreset_mode a mode of Gymnasium's AutoresetMode, or its name
        @param options text, seed, ticks, threads, overrides, as of Worlds"""
        self._observed, self._commanded = Fields(observations, is_action=False), Actions(actions, choices)
        self._mode = _mode(autoreset_mode)
        self.metadata = {"render_modes": ["rgb_array"], "autoreset_mode": self._mode}
        self.render_mode, self._camera, self._pictures = mode_of_pictures(render_mode), camera or PICTURE, None
        self._reward, (self._sign, metric) = reward, signed(reward) if isinstance(reward, str) else (1.0, None)
        self.worlds = Worlds(experiment, num_envs, observations=self._observed.names, actions=self._commanded.fields.names,
                             controller=controller, reward=metric, ticks_per_step=ticks_per_step,
                             autoreset="disabled", **options)
        self.num_envs, robots = len(self.worlds), self.worlds.robots
        self.single_observation_space, self.observation_space = (self._observed.box(*shape) for shape in
                                                                 ((robots,), (self.num_envs, robots)))
        self.single_action_space, self.action_space = (self._commanded.space(*shape) for shape in
                                                       ((robots,), (self.num_envs, robots)))
        self.robot_rewards = numpy.zeros((self.num_envs, robots))
        self._over = numpy.zeros(self.num_envs, bool)    # worlds whose run has ended in the last step
        self._first = numpy.ones(self.num_envs, bool)    # worlds without a step since their reset

    def reset(self, *, seed=None, options=None):
        """Starts runs. @param seed of the first world, each further one has the next; or a list with one for each world; None:
        each world's last one plus the number of worlds
        @param options {"reset_mask": (worlds,)} resets some worlds only
        @return observations, and a dictionary with `ticks`"""
        mask = None if options is None else options.get("reset_mask")
        chosen = numpy.ones(self.num_envs, bool) if mask is None else numpy.asarray(mask)
        if isinstance(seed, (int, numpy.integer)):
            self.action_space.seed(int(seed))
            seed = numpy.arange(self.num_envs, dtype=numpy.uint64) + numpy.uint64(seed)
        self._reset(chosen, None if seed is None else numpy.asarray(seed, numpy.uint64))
        self.robot_rewards[chosen] = 0.0
        return self.worlds.observations.copy(), self._ticks()

    def step(self, actions):
        """@param actions (num_envs, robots, numbers), or (num_envs, robots) with choices; those of worlds that a step resets, or
        that are over, are ignored
        @return observations, rewards, terminated, truncated, info"""
        numbers = self._commanded.numbers(actions)
        self.worlds.step(numbers)
        rewards = self._rewards(numbers)
        self._first &= self._over
        over = self._over.copy()
        if self._mode is AutoresetMode.NEXT_STEP and over.any():
            self._reset(over)
        terminated, truncated = self.worlds.terminated.copy(), self.worlds.truncated.copy()
        info = self._ticks()
        ended = (terminated | truncated) & ~over
        final = self._metrics(ended)
        if self._mode is AutoresetMode.SAME_STEP and ended.any():
            ticks = {key: value.copy() for key, value in info.items()}
            ticks["_ticks"] = ended.copy()
            last = numpy.full(self.num_envs, None, object)
            for world in numpy.flatnonzero(ended):
                last[world] = self.worlds.observations[world].copy()
            self._reset(ended)
            info = {**self._ticks(), "final_obs": last, "_final_obs": ended.copy(), "final_info": {**ticks, **final},
                    "_final_info": ended.copy()}
        else:
            info.update(final)
            self._over = terminated | truncated
        return self.worlds.observations.copy(), rewards, terminated, truncated, info

    def _reset(self, chosen, seeds=None):
        self.worlds.reset(chosen, seeds=seeds)
        self._over = self._over & ~chosen
        self._first = self._first | chosen

    def _rewards(self, actions):
        """Rewards of worlds, (num_envs,); those of robots are kept."""
        if isinstance(self._reward, str):
            self.robot_rewards = numpy.where(self._first[:, None], 0.0, self._sign * self.worlds.rewards.astype(float))
            # all robots that are present have the same reward, and the others 0
            return self.robot_rewards.max(axis=1, initial=0.0) + self.robot_rewards.min(axis=1, initial=0.0)
        rewards = numpy.asarray(self._reward(Swarms(self.worlds, actions)), float)
        shape = self.robot_rewards.shape
        if rewards.shape not in (shape, shape[:1]):
            raise ValueError(f"reward: found the shape {rewards.shape}, allowed: {shape} or {shape[:1]}")
        each = rewards if rewards.shape == shape else rewards[:, None]
        self.robot_rewards = numpy.where(self.worlds.present & ~self._over[:, None], each, 0.0)
        return self.robot_rewards.sum(axis=1) if rewards.shape == shape else numpy.where(self._over, 0.0, rewards)

    def _ticks(self):
        return {"ticks": self.worlds.ticks, "_ticks": numpy.ones(self.num_envs, bool)}

    def _metrics(self, ended):
        """The metrics of worlds that have ended, with masks."""
        info = {}
        for world in numpy.flatnonzero(ended):
            for name, value in self.worlds.metrics(int(world)).items():
                if name not in info:
                    kind = object if isinstance(value, str) else type(value)
                    info[name] = numpy.full(self.num_envs, None, object) if kind is object else numpy.zeros(self.num_envs, kind)
                    info[f"_{name}"] = numpy.zeros(self.num_envs, bool)
                info[name][world], info[f"_{name}"][world] = value, True
        return info

    def state(self):
        """All worlds, for a critic: (num_envs, robots and other movable entities, 14), each as Env.state."""
        return self.worlds.state.copy()

    def render(self):
        """A picture of each world as it is, a tuple of (height, width, 3), uint8, in the mode rgb_array; else None."""
        if self.render_mode is None:
            return None
        if self._pictures is None:
            self._pictures = [self.worlds.pictures(world, self._camera) for world in range(self.num_envs)]
        return tuple(pictures.take() for pictures in self._pictures)

    def close(self, **_):
        """No step follows."""
        self.closed, self._pictures = True, None

    @property
    def unwrapped(self):
        """The environment itself."""
        return self

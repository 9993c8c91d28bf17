"""Installed experiments as environments, with observations, actions and a reward for each."""

from ._core import installed_experiments
from ._env import Env

FASTEST = 10.3   # of a footbot's wheel [rad/s]: 0.3 m/s
WHEELS = {"footbot_wheels.left": (-FASTEST, FASTEST), "footbot_wheels.right": (-FASTEST, FASTEST)}
GRIPPER = {**WHEELS, "footbot_gripper.closed": (0, 1)}
SENDS = {"range_and_bearing.sends": (0, 1)}
FLIES = {"eyebot_velocity.linear": (-0.5, 0.5), "eyebot_velocity.yaw_rate": (-1, 1)}
PROXIMITY, GRIPPING = "footbot_proximity.value", "footbot_gripper_state.gripping"
LAMPS = [PROXIMITY, "light.sensors.value[sectors=8]"]


def seen(*colors, sectors=12, maximum=3):
    """How near the camera sees the nearest blob of each colour in each sector; without colours of any."""
    wanted = f" colors={','.join(colors)}" if colors else ""
    return f"footbot_camera.blobs.distance[sectors={sectors} near maximum={maximum}{wanted}]"


def heard(sectors=8, maximum=3):
    """How near the nearest sender of messages is in each sector."""
    return f"range_and_bearing_received.messages.range[sectors={sectors} near maximum={maximum}]"


FORAGING = [seen("yellow", "green", "blue", maximum=6), PROXIMITY, GRIPPING]
RETRIEVAL = [seen(maximum=2), PROXIMITY, GRIPPING]
CLIMBER = ["handbot_arms_state.joints.angle", "handbot_hands_state.left.holding", "handbot_hands_state.right.holding",
           "handbot_rope_state.length"]
CLIMBS = {"handbot_arms.left.shoulder": None, "handbot_arms.right.shoulder": None, "handbot_hands.left": (0, 1),
          "handbot_hands.right": (0, 1), "handbot_rope.shot": (0, 1), "handbot_rope.winding_speed": (-0.2, 0.2)}

# by experiment: observations, actions, id of the controller whose robots act, metric whose rise (-: fall) rewards
TASKS = {
    "aggregation": ([seen(sectors=8)], {**WHEELS, "footbot_leds.ring.green": None}, "ac", "-dispersion.second_moment"),
    "battery_foraging": ([*FORAGING, "battery.charge"], {**GRIPPER, "footbot_leds.ring.blue": None}, "fc", "foraging.preys"),
    "chain_formation": ([seen(), PROXIMITY], {**WHEELS, "footbot_beacon.color.blue": None}, "cc", "path.links"),
    "charging": ([seen("cyan", "orange"), PROXIMITY, "battery.charge"], WHEELS, "cc", "charging.mean_level"),
    "climbing": (CLIMBER, CLIMBS, "climbing", "down.mean"),
    "diffusion": ([PROXIMITY], WHEELS, "dc", "coverage.area"),
    "emergent_taxis": ([heard(), "light.sensors.value[sectors=8]"], {**WHEELS, **SENDS}, "tc", "taxis.progress"),
    "evolved_retrieval": (RETRIEVAL, GRIPPER, "fc", "-retrieval_ticks"),
    "eyebot_flocking": ([heard(maximum=10), "positioning.heading"], {**FLIES, **SENDS}, "ec", "flock.order"),
    "flocking": ([heard(), seen(maximum=2)], {**WHEELS, **SENDS}, "fc", "flock.order"),
    "foraging": (FORAGING, {**GRIPPER, "footbot_leds.ring.blue": None}, "fc", "foraging.preys"),
    "gap": ([GRIPPING], GRIPPER, "chain", "crossed.inside"),
    "group_pull": ([GRIPPING], GRIPPER, "pull", "-retrieval_ticks"),
    "neural_aggregation": ([heard(sectors=4)], {**WHEELS, **SENDS}, "nc", "-dispersion.second_moment"),
    "neural_phototaxis": (LAMPS, WHEELS, "nc", "-lamps.distance"),
    "object_retrieval": (RETRIEVAL, GRIPPER, "fc", "-retrieval_ticks"),
    "phototaxis": (LAMPS, WHEELS, "pc", "-lamps.distance"),
    "predators": ([heard(), seen()], {**WHEELS, **SENDS}, "pc", "-prey_distance.mean"),
    "rough_terrain": ([PROXIMITY], WHEELS, "dc", "coverage.area"),
    "shelf_retrieval": (CLIMBER, CLIMBS, "climbing", "down.mean"),
    "trail": ([PROXIMITY, "footbot_ground.value"], WHEELS, "fc", "trips.trips"),
    "two_spot_foraging": ([*LAMPS, "ground.sensors.value[count=4]"], WHEELS, "bc", "items.returns"),
}


def make(name, kind=Env, **options):
    """An environment of an installed experiment, with the observations, the actions and the reward that its page states.

    @param kind Env, ParallelEnv or VectorEnv @param options others than these, or instead of them
    @throws ValueError for an experiment without robots that could learn its task

    >>> env = make("aggregation", ParallelEnv, ticks=50)
    >>> observations, infos = env.reset(seed=2)
    >>> len(env.agents), observations["fb_1"].shape
    (16, (8,))
    """
    if name not in TASKS:
        known = ", ".join(sorted(set(TASKS) & set(installed_experiments())))
        raise ValueError(f"found the experiment '{name}', allowed: {known}")
    observations, actions, controller, reward = TASKS[name]
    return kind(name, **{"observations": observations, "actions": actions, "controller": controller, "reward": reward, **options})

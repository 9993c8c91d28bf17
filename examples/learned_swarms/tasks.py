"""Tasks for train.py: the experiment, what a robot sees and commands, and what it is rewarded for."""

import numpy

FASTEST = 5.2   # of a wheel [rad/s]: 0.15 m/s, as the controllers by hand drive
WHEELS = {"footbot_wheels.left": (-FASTEST, FASTEST), "footbot_wheels.right": (-FASTEST, FASTEST)}


class Aggregation:
    """Sixteen footbots of the experiment, here twenty, gather. The camera shows in eight sectors how near others are."""

    experiment, controller, metric, ticks = "aggregation", "ac", "dispersion.largest_cluster", 400
    overrides = {"arena.distribute.quantity": 20}
    observations = ["footbot_camera.blobs.distance[sectors=8 near maximum=3]"]
    constants = {"footbot_leds.ring.green": 255}   # the light by which they see each other

    def begin(self, swarms):
        self.before = self.mean_distance(swarms.poses)

    @staticmethod
    def distances(poses):
        places = poses[..., :2]
        return numpy.hypot(*numpy.moveaxis(places[:, :, None] - places[:, None], -1, 0))

    def mean_distance(self, poses):
        return self.distances(poses).mean(axis=2)

    def reward(self, swarms):
        """Coming nearer to the others, and having neighbours: (worlds, robots)."""
        now = self.mean_distance(swarms.poses)
        neighbours = numpy.minimum((self.distances(swarms.poses) < 0.34).sum(axis=2) - 1, 4)
        gained, self.before = 2 * (self.before - now) + 0.01 * neighbours, now
        return gained

    def known(self, poses):
        """What the critic knows besides: (worlds, robots, numbers)."""
        return self.mean_distance(poses)[..., None]


class TwoSpotForaging:
    """Twenty footbots bring items from two black spots to a white nest. They see the floor under them, the lamp behind the nest
    and obstacles, and remember nothing."""

    experiment, controller, metric, ticks = "two_spot_foraging", "bc", "items.returns", 1200
    overrides, constants = {}, {}
    observations = ["footbot_proximity.value", "ground.sensors.value[count=4]", "light.sensors.value[sectors=8]"]
    spots = numpy.array([[1.25, 2.3], [2.75, 2.3]])

    def begin(self, swarms):
        self.has_item = numpy.zeros(swarms.present.shape, bool)
        self.before = self.way(swarms.poses)

    def on(self, poses):
        x, y = poses[..., 0], poses[..., 1]
        spot = (numpy.linalg.norm(poses[:, :, None, :2] - self.spots, axis=3) < 0.15).any(axis=2)
        return spot, (abs(x - 2) < 1.3) & (abs(y - 1.05) < 0.35)

    def way(self, poses):
        """How far it is to the nest, or for a robot without an item to the nearer spot [m]."""
        to_spot = numpy.linalg.norm(poses[:, :, None, :2] - self.spots, axis=3).min(axis=2)
        return numpy.where(self.has_item, numpy.maximum(poses[..., 1] - 1.4, 0), to_spot)

    def reward(self, swarms):
        """Picking up and delivering items, and coming nearer to them: (worlds, robots)."""
        spot, nest = self.on(swarms.poses)
        gained = 0.5 * (self.before - self.way(swarms.poses)) + 1.0 * (self.has_item & nest) + 0.5 * (~self.has_item & spot)
        self.has_item = (self.has_item | spot) & ~nest
        self.before = self.way(swarms.poses)
        return gained

    def known(self, poses):
        """What the critic knows besides: whether a robot has an item, and its pose."""
        yaw = 2 * numpy.arctan2(poses[..., 5], poses[..., 6])
        return numpy.stack([self.has_item, poses[..., 0] - 2, poses[..., 1] - 2, numpy.cos(yaw), numpy.sin(yaw), self.way(poses)], axis=2)


TASKS = {"aggregation": Aggregation, "foraging": TwoSpotForaging}

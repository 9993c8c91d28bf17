"""Overlaps of footbots' bodies, which are upright or leaning cylinders. Arrays have a body, or a pair of bodies, in each row."""

import numpy

RADIUS = 0.085       # [m]
HALF_HEIGHT = 0.068  # [m]


def axes_of(poses):
    """@return upward axes of robots, one a row"""
    x, y, z, w = poses[:, 3:7].T
    return numpy.column_stack((2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)))


def reach(axes, directions):
    """@return how far bodies reach from their centres along unit directions [m]"""
    along = numpy.clip(numpy.abs((axes * directions).sum(-1)), 0, 1)
    return HALF_HEIGHT * along + RADIUS * numpy.sqrt(1 - along**2)


def least(centre, grid, depth_at):
    """@return for each pair, the least depth near a centre, found by grids that get finer
    @param centre coordinates, one or two in each row @param grid of offsets of -1 to 1, for each coordinate
    @param depth_at depths by coordinates, pairs x grid x coordinates"""
    pairs = numpy.arange(len(centre))
    width = 1.0  # of half a grid [rad]
    while width > 1e-7:
        tried = centre[:, None] + width * grid
        depth = depth_at(tried)
        best = depth.argmin(1)
        centre = tried[pairs, best]
        width *= 0.4
    return depth[pairs, best]


def depths(centres_a, axes_a, centres_b, axes_b):
    """@return for each pair of bodies, the shortest way that parts them [m]: the least over all directions. The depth has
    kinks where a direction is across an axis, so directions across each axis are searched, and all directions"""
    apart = centres_b - centres_a
    line = numpy.linspace(-1, 1, 41)

    def depth_along(directions):
        return (reach(axes_a[:, None], directions) + reach(axes_b[:, None], directions)
                - (apart[:, None] * directions).sum(-1))

    def across(axes):
        """@return least depth of directions across axes; angles are from the one nearest to the other body"""
        ahead = apart - (apart * axes).sum(-1, keepdims=True) * axes
        ahead /= numpy.linalg.norm(ahead, axis=-1, keepdims=True)
        aside = numpy.cross(axes, ahead)
        return least(numpy.zeros((len(apart), 1)), line[:, None], lambda angle: depth_along(
            numpy.cos(angle) * ahead[:, None] + numpy.sin(angle) * aside[:, None]))

    def anywhere(angles):
        azimuth, elevation = angles[..., 0], angles[..., 1]
        return depth_along(numpy.stack((numpy.cos(elevation) * numpy.cos(azimuth), numpy.cos(elevation) * numpy.sin(azimuth),
                                        numpy.sin(elevation)), -1))

    start = numpy.column_stack((numpy.arctan2(apart[:, 1], apart[:, 0]), numpy.zeros(len(apart))))
    square = numpy.stack(numpy.meshgrid(line[::4], line[::4]), -1).reshape(-1, 2)
    return numpy.fmin.reduce([across(axes_a), across(axes_b), least(start, square, anywhere)])

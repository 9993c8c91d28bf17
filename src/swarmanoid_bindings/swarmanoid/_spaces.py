"""Spaces of observations and actions, with the attributes of Gymnasium's, and the fields of devices that make them up."""

import numpy

from ._core import bounds_of, fields_of


class Space:
    """What spaces have in common: a shape, a type, and samples from a generator with a seed."""

    def __init__(self, shape, dtype, seed=None):
        self.shape, self.dtype = tuple(shape), numpy.dtype(dtype)
        self.seed(seed)

    def seed(self, seed=None):
        """Seeds the random numbers of samples."""
        self._random = numpy.random.default_rng(seed)
        return [seed]

    def __contains__(self, value):
        return self.contains(value)


class Box(Space):
    """A space of arrays of one shape, with bounds for each number."""

    def __init__(self, low, high, dtype=numpy.float32, seed=None):
        """@param low, high arrays of the same shape"""
        self.low, self.high = numpy.asarray(low, dtype), numpy.asarray(high, dtype)
        if self.low.shape != self.high.shape or not (self.low <= self.high).all():
            raise ValueError(f"found bounds from {low!r} to {high!r}, allowed: of one shape, none above the other")
        super().__init__(self.low.shape, dtype, seed)

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
        """Whether an array has the shape, a type that fits, and no number out of bounds."""
        array = numpy.asarray(value)
        return bool(array.shape == self.shape and numpy.can_cast(array.dtype, self.dtype, "same_kind")
                    and (array >= self.low).all() and (array <= self.high).all())

    def is_bounded(self, manner="both"):
        """@param manner "below", "above" or "both" """
        below, above = numpy.isfinite(self.low).all(), numpy.isfinite(self.high).all()
        return bool({"both": below and above, "below": below, "above": above}[manner])

    def __eq__(self, other):
        return (isinstance(other, Box) and self.dtype == other.dtype and numpy.array_equal(self.low, other.low)
                and numpy.array_equal(self.high, other.high))

    def __repr__(self):
        return f"Box(shape={self.shape}, dtype={self.dtype})"


class Discrete(Space):
    """A space of whole numbers from 0 to n - 1."""

    start = 0

    def __init__(self, n, seed=None):
        """@param n how many, from 1"""
        if int(n) != n or n < 1:
            raise ValueError(f"n: found {n}, allowed: a whole number from 1")
        self.n = int(n)
        super().__init__((), numpy.int64, seed)

    def sample(self):
        """A number, each with the same probability."""
        return numpy.int64(self._random.integers(self.n))

    def contains(self, value):
        """Whether it is one of these numbers."""
        number = numpy.asarray(value)
        return bool(number.shape == () and number.dtype.kind in "iu" and 0 <= number < self.n)

    def __eq__(self, other):
        return isinstance(other, Discrete) and self.n == other.n

    def __repr__(self):
        return f"Discrete({self.n})"


class MultiDiscrete(Space):
    """A space of arrays of whole numbers, each from 0 to one less than its entry in `nvec`."""

    def __init__(self, nvec, dtype=numpy.int64, seed=None):
        """@param nvec an array of whole numbers from 1, of the shape of the space"""
        self.nvec = numpy.asarray(nvec, dtype)
        if self.nvec.size == 0 or not (self.nvec >= 1).all():
            raise ValueError(f"nvec: found {nvec!r}, allowed: whole numbers from 1")
        super().__init__(self.nvec.shape, dtype, seed)

    def sample(self):
        """Numbers, each with the same probability."""
        return self._random.integers(self.nvec, dtype=self.dtype)

    def contains(self, value):
        """Whether an array has the shape, and each number is one of its own."""
        array = numpy.asarray(value)
        return bool(array.shape == self.shape and array.dtype.kind in "iu" and (array >= 0).all() and (array < self.nvec).all())

    def __eq__(self, other):
        return isinstance(other, MultiDiscrete) and numpy.array_equal(self.nvec, other.nvec)

    def __repr__(self):
        return f"MultiDiscrete(shape={self.shape})"


class Fields:
    """Names of fields of devices, and the bounds of the numbers that they have for a robot."""

    def __init__(self, fields, is_action):
        """@param fields names such as "footbot_proximity.value", or a dictionary of these with (low, high)"""
        given = dict(fields) if isinstance(fields, dict) else dict.fromkeys(fields)
        self.names = list(given)
        if not self.names:
            raise ValueError("found no fields, allowed: one or more, such as 'footbot_proximity.value'")
        for name in self.names:
            fields_of(name.partition(".")[0])   # a KeyError for an unknown device
        low, high = [], []
        for (bounds, known) in zip(given.values(), bounds_of(self.names, is_action)):
            low += [known_low if bounds is None else bounds[0] for known_low, _ in known]
            high += [known_high if bounds is None else bounds[1] for _, known_high in known]
        self.low, self.high = numpy.array(low, float), numpy.array(high, float)
        self.size = len(low)

    def box(self, *shape):
        """A Box of the numbers of a robot, repeated to the shape in front."""
        return Box(numpy.broadcast_to(self.low, (*shape, self.size)), numpy.broadcast_to(self.high, (*shape, self.size)))


class Actions:
    """The choice for a robot in a step: the numbers of its fields, or one of several vectors of these."""

    def __init__(self, fields, choices=None):
        """@param fields as of Fields @param choices vectors of numbers of these fields, (choices, numbers); None: any"""
        self.fields = Fields(fields, is_action=True)
        self.choices = None if choices is None else numpy.asarray(choices, float)
        if choices is not None and (self.choices.ndim != 2 or self.choices.shape[1] != self.fields.size
                                    or len(self.choices) == 0):
            raise ValueError(f"choices: found the shape {self.choices.shape}, allowed: (choices, {self.fields.size})")

    def space(self, *shape):
        """The space of the actions of robots of a shape; of one robot without a shape."""
        if self.choices is None:
            return self.fields.box(*shape)
        return MultiDiscrete(numpy.full(shape, len(self.choices))) if shape else Discrete(len(self.choices))

    def numbers(self, actions):
        """The numbers of fields for chosen actions. @param actions of the shape of the space
        @throws ValueError for a choice that there is not"""
        if self.choices is None:
            return actions
        chosen = numpy.asarray(actions)
        if chosen.dtype.kind not in "iu" or (chosen < 0).any() or (chosen >= len(self.choices)).any():
            raise ValueError(f"actions: found {chosen.tolist()}, allowed: whole numbers from 0 to {len(self.choices) - 1}")
        return self.choices[chosen]

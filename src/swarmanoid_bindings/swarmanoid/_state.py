"""State of Python controllers and rules for snapshots: their attributes, pickled."""

import pickle

import numpy

from . import _single


def _is_of_robot(value):
    """Whether a value is what a controller keeps of its robot: the robot, its devices, or arrays in their memory. The
    simulation saves their state itself."""
    while isinstance(value, numpy.ndarray):
        if value.base is None:
            return False
        value = value.base
    return isinstance(value, _single.Robot) or type(value).__module__ in (_single.__name__, "swarmanoid._core")


def _attributes(thing):
    """The attributes of an object, or of the object of a bound function; None without any."""
    return getattr(getattr(thing, "__self__", thing), "__dict__", None)


def save(thing):
    """@return bytes"""
    attributes = _attributes(thing) or {}
    return pickle.dumps({name: value for name, value in attributes.items() if not _is_of_robot(value)})


def load(thing, state):
    """Gives an object the attributes that `save` has saved, and no others besides what it keeps of its robot."""
    attributes = _attributes(thing)
    saved = pickle.loads(state)
    if attributes is not None:
        for name in [name for name, value in attributes.items() if not _is_of_robot(value)]:
            del attributes[name]
        attributes.update(saved)

"""Robots for controllers that are a class, with one object per robot.

A device is an object with an attribute per field. Attributes access memory of the host (robot_host.hpp), which copies fields
from the run before each step and back after it, so an access costs a fraction of a microsecond. Each type of device gets a
class of its own, made once."""

import difflib

import numpy


def unknown(what, name, known):
    near = difflib.get_close_matches(name, known, 1)
    return f"found {what} '{name}', allowed: {', '.join(sorted(known))}" + (f"; did you mean '{near[0]}'?" if near else "")


class Part:
    """A device of one robot, or a part of it, with its fields as attributes."""
    __slots__ = ("_at", "_host")

    def __getattr__(self, name):
        raise AttributeError(unknown(f"the field of {type(self).__name__}", name, self._names))

    def __dir__(self):
        return sorted(self._names)

    def __repr__(self):
        return f"<{type(self).__name__}: {', '.join(self.__dir__())}>"


def number_field(slot, name, device, is_writable):
    """A property for a single number; `slot` holds the numbers of all robots."""
    def get(part):
        return getattr_slot(part)[part._at]

    getattr_slot = slot.__get__

    def put(part, value):
        try:
            getattr_slot(part)[part._at] = value
        except (TypeError, ValueError) as error:
            raise type(error)(f"{device}.{name}: found {value!r}, allowed: a number of its type") from None

    return property(get, put if is_writable else None)


def array_field(slot, name, device, is_writable):
    """A property for several numbers. Readings are read-only copies, which keep the values of their step. Commands are an array
    that is written back at the end of the step, the same for each access in it, and read-only from then on."""
    row_of = slot.__get__

    def get_reading(part):
        copy = row_of(part).copy()
        copy.setflags(write=False)
        return copy

    def get_command(part):
        return part._host.hand_out(row_of(part))

    def put(part, value):
        if not part._host.is_in_step:
            raise RuntimeError("the robot is between two steps: this can be done in a step of its controller")
        array = get_command(part)
        given = numpy.asarray(value)
        with numpy.errstate(all="ignore"):
            converted = given.astype(array.dtype) if given.dtype.kind in "biuf" else None
        if converted is None or (array.dtype.kind != "f" and not numpy.array_equal(converted, given)):
            raise ValueError(f"{device}.{name}: found {value!r}, allowed: numbers that are {array.dtype}")
        try:
            array[...] = converted
        except ValueError:
            raise ValueError(f"{device}.{name}: found the shape {given.shape}, allowed: {array.shape}") from None

    return property(get_command, put) if is_writable else property(get_reading)


def list_field(full, device):
    return property(lambda part: part._host.elements(device, full, part._at))


def first_words(names):
    """Groups names by their first part: "ring.red" and "value" give {"ring": ["red"], "value": [""]}."""
    words = {}
    for name in names:
        first, _, rest = name.partition(".")
        words.setdefault(first, []).append(rest)
    return words


def part_class(device, prefix, fields, lists, is_writable):
    """@param fields number of dimensions of each field's array, by name without the prefix"""
    words = first_words([*fields, *lists])
    slots = [f"_{word}" for word in words]
    base = type(f"{device}.{prefix}".rstrip("."), (Part,), {"__slots__": slots})
    namespace = {"__slots__": (), "_names": list(words), "_parts": {}, "_numbers": [], "_arrays": [], "_prefix": prefix}
    for word in words:
        slot = base.__dict__[f"_{word}"]
        if word in lists:
            namespace[word] = list_field(prefix + word, device)
        elif word not in fields:
            inner = {name[len(word) + 1:]: size for name, size in fields.items() if name.startswith(word + ".")}
            inner_lists = [name[len(word) + 1:] for name in lists if name.startswith(word + ".")]
            namespace["_parts"][word] = part_class(device, f"{prefix}{word}.", inner, inner_lists, is_writable)
            namespace[word] = property(slot.__get__)
        elif fields[word] == 1:
            namespace["_numbers"].append(word)
            namespace[word] = number_field(slot, prefix + word, device, is_writable)
        else:
            namespace["_arrays"].append(word)
            namespace[word] = array_field(slot, prefix + word, device, is_writable)
    made = type(base.__name__, (base,), namespace)
    made.__module__ = __name__
    return made


def bind(part, host, arrays, at):
    """Connects the part to the robot with index `at` of the host. @param arrays by name of the field"""
    kind = type(part)
    part._host = host
    part._at = at
    for word in kind._numbers:
        setattr(part, f"_{word}", memoryview(arrays[kind._prefix + word]))
    for word in kind._arrays:
        setattr(part, f"_{word}", arrays[kind._prefix + word][at])
    for word, inner in kind._parts.items():
        if not hasattr(part, f"_{word}"):
            setattr(part, f"_{word}", inner())
        bind(getattr(part, f"_{word}"), host, arrays, at)


CLASSES = {}


def class_of(device, arrays, lists, is_writable):
    if device not in CLASSES:
        CLASSES[device] = part_class(device, "", {name: array.ndim for name, array in arrays.items()}, lists, is_writable)
    return CLASSES[device]


class Devices(dict):
    """The devices of a robot, by type."""

    def __missing__(self, name):
        raise KeyError(unknown("the device", name, self))


class Robot:
    """One robot, for its controller: valid as long as it has this controller.

    readings and commands are its devices by type, robot.readings["footbot_proximity"].value, with the fields of the reference
    of devices, in SI units and radians. A device stays the same object, so it can be stored in `init`; its readings are those of
    the current step. Arrays belong to their step: those of readings are read-only, those of commands are written in place until
    the step ends."""

    def __init__(self, host):
        self.readings = Devices()
        self.commands = Devices()
        self.name = host.name(0)
        self.type = host.type(0)
        self._bind(host, 0)

    def _bind(self, host, at):
        self._host = host
        self._at = at
        for devices, found, is_writable in ((self.readings, host.sensors, False), (self.commands, host.actuators, True)):
            for device, (arrays, lists) in found.items():
                if device not in devices:
                    devices[device] = class_of(device, arrays, lists, is_writable)()
                bind(devices[device], host, arrays, at)

    @property
    def tick(self):
        """Number of this tick; the first one is 0."""
        return self._host.tick

    @property
    def time(self):
        """Simulated time since the start [s]."""
        return self._host.time

    @property
    def dt(self):
        """Time of a tick [s]."""
        return self._host.dt

    def uniform(self, low=0.0, high=1.0):
        """The next number of the robot's own random stream, from low to high."""
        return self._host.uniform(self._at, low, high)

    def gaussian(self, mean=0.0, standard_deviation=1.0):
        """The next number of the robot's own random stream, normally distributed."""
        return self._host.gaussian(self._at, mean, standard_deviation)

    def log(self, text):
        """Writes a line to the log."""
        self._host.log(self._at, text)

    def debug(self, key, value):
        """Sets a named debug value, shown to users."""
        self._host.debug(self._at, key, value)

    def __repr__(self):
        return f"<{self.type} '{self.name}'>"

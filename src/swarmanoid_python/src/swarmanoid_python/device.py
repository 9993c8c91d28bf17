"""Devices for controllers, with their fields by name.

    robot.actuators.footbot_wheels.left = 2.0
    robot.sensors.footbot_proximity.value[3]
    robot.actuators.handbot_arms.left.elbow
    robot.sensors.footbot_camera.blobs[0].distance

Names may also be strings: robot.sensors["handbot_arms_state"]["joints[2].angle"]. Values are Python numbers, not
numpy's: a float has the precision of a C++ double, so that the same arithmetic has the same result in both languages.
`numpy.asarray` makes an array of any field that has several numbers."""

import collections.abc
import operator

from .names import Fields, UnknownName, parts


def _row(path, values, count):
    """@return the values as a list; @raise ValueError if their number differs from `count`"""
    try:
        values = iter(values)
    except TypeError:
        raise ValueError(f"{path}: found {values!r}, allowed: {count} values") from None
    values = list(values)
    if len(values) != count:
        raise ValueError(f"{path}: found {len(values)} values, allowed: {count}")
    return values


def _check_index(path, elements, index):
    count = len(elements)
    if not isinstance(index, int):
        raise UnknownName(f"{path}: found no field", index, [f"[0] to [{count - 1}]"] if count else [])
    if index >= count:
        allowed = f"0 to {count - 1}" if count else "none"
        raise IndexError(f"{path}: found index {index}, allowed: {allowed}; elements in the list: {count}")


class View:
    """A field with fields of its own, or an array. It stores no values: it reads and writes those of its device."""

    __slots__ = ("_values", "_fields")

    def __init__(self, values, fields):
        object.__setattr__(self, "_values", values)
        object.__setattr__(self, "_fields", fields)

    def __reduce__(self):  # a copy has its own copy of the values
        return type(self), (type(self._values)(self._values), self._fields)

    def _get(self, key):
        found = self._fields.find(key)
        return View(self._values, found) if isinstance(found, Fields) else self._values[found]

    def _set(self, key, value):
        found = self._fields.find(key)
        if isinstance(found, Fields):
            View(self._values, found)._fill(list(found), value)
        else:
            self._values[found] = value

    def _fill(self, keys, values):
        for key, value in zip(keys, _row(self._fields.path, values, len(keys))):
            self._set(key, value)

    def _at(self, name):
        """@return the container of the named field and the field's key in it: for "left.elbow" the view of left and
        "elbow", for "blobs[0]" the list and 0"""
        holder, key, shown = self, None, self._fields.path
        for part in parts(name):
            if key is not None:
                holder = holder._get(key) if isinstance(holder, View) else holder[key]
                shown += f"[{key}]" if isinstance(key, int) else f"/{key}"
            if isinstance(holder, (list, tuple)):
                _check_index(shown, holder, part)
            elif not isinstance(holder, View):
                raise self._fields.unknown(name)
            key = part
        if key is None:
            raise self._fields.unknown(name)
        return holder, key

    def __getattr__(self, name):
        return self._get(name)

    def __setattr__(self, name, value):
        self._set(name, value)

    def __getitem__(self, key):
        if isinstance(key, str):
            holder, last = self._at(key)
            return holder._get(last) if isinstance(holder, View) else holder[last]
        if isinstance(key, slice):
            return [self._get(each) for each in list(self._fields)[key]]
        return self._get(self._fields.key_at(operator.index(key)))

    def __setitem__(self, key, value):
        if isinstance(key, str):
            holder, last = self._at(key)
            if isinstance(holder, View):
                holder._set(last, value)
            else:
                holder[last] = value
        elif isinstance(key, slice):
            self._fill(list(self._fields)[key], value)
        else:
            self._set(self._fields.key_at(operator.index(key)), value)

    def __len__(self):
        return len(self._fields)

    def __iter__(self):
        return (self._get(key) for key in self._fields)

    def __eq__(self, other):
        return list(self) == list(other) if isinstance(other, collections.abc.Iterable) else NotImplemented

    __hash__ = None

    def __dir__(self):
        return [key for key in self._fields if isinstance(key, str)]

    def __repr__(self):
        return repr(list(self)) if 0 in self._fields else \
            "(" + ", ".join(f"{key}={self._get(key)!r}" for key in self._fields) + ")"


class Device(View):
    """A device, or an element of a list in one. Indexed by numbers it is the flat sequence of all values in wire order:
    nested fields and arrays one after the other. Elements of lists are read-only."""

    __slots__ = ()

    def __getitem__(self, key):
        return super().__getitem__(key) if isinstance(key, str) else self._values[key]

    def __setitem__(self, key, value):
        if isinstance(key, slice):
            value = _row(self._fields.path, value, len(self._values[key]))
        if isinstance(key, str):
            super().__setitem__(key, value)
        else:
            self._values[key] = value

    def __len__(self):
        return len(self._values)

    def __iter__(self):
        return iter(self._values)

    def __repr__(self):
        return self._fields.path + super().__repr__()


def replace_values(device, values):
    """Replaces the values of a device in place; all references to the device see them."""
    values = list(values)
    for place, fields in device._fields.lists.items():
        values[place] = [Device(tuple(element), fields) for element in values[place]]
    device._values[:] = values


class Devices(collections.abc.Mapping):
    """The sensors or the actuators of a robot by type, sensors.footbot_proximity or sensors["footbot_proximity"]. An
    assignment to a device sets its values, in wire order."""

    __slots__ = ("_kind", "_devices")

    def __init__(self, kind, devices):
        """@param kind "sensor" or "actuator"; @param devices Device by type"""
        object.__setattr__(self, "_kind", kind)
        object.__setattr__(self, "_devices", dict(devices))

    def __reduce__(self):
        return type(self), (self._kind, self._devices)

    def __getitem__(self, device):
        if device not in self._devices:
            raise UnknownName(f"found no {self._kind}", device, self._devices)
        return self._devices[device]

    def __setitem__(self, device, values):
        self[device][:] = values

    def __getattr__(self, device):
        return self[device]

    def __setattr__(self, device, values):
        self[device] = values

    def __iter__(self):
        return iter(self._devices)

    def __len__(self):
        return len(self._devices)

    def __dir__(self):
        return list(self._devices)

    def __repr__(self):
        return f"{self._kind}s: {', '.join(self._devices) or 'none'}"

"""Devices with their fields by name, as the space tells them: "left right", "value[0] value[1] ...", and for a list the names of
its elements in brackets behind its own, "blobs(color.red distance) overflowed"."""

import collections
import re

_PART = re.compile(r"([^.\[\]]+)|\[(\d+)\]")


def _parts(name):
    """"joints[2].angle" as ["joints", 2, "angle"]"""
    return [word or int(index) for word, index in _PART.findall(name)]


def _insert(tree, parts, leaf):
    """Puts a leaf below its parts into dictionaries; those whose keys are 0, 1, 2, ... stand for arrays."""
    for part in parts[:-1]:
        tree = tree.setdefault(part, {})
    tree[parts[-1]] = leaf


class Names:
    """The names of the values of one device type."""

    def __init__(self, text):
        self.tree = {}      # field: place in the list of values, or what is in the field
        self.elements = {}  # place of a list: class of its elements
        for place, (name, inner) in enumerate(re.findall(r"([^\s()]+)(?:\(([^()]*)\))?", text)):
            _insert(self.tree, _parts(name), place)
            if inner:
                self.elements[place] = collections.namedtuple(name, [re.sub(r"\W+", "_", each).strip("_") for each in inner.split()])

    def named(self, values):
        """The values, in which elements of lists are tuples with names."""
        for place, element in self.elements.items():
            if place < len(values):
                values[place] = [element(*each) for each in values[place]]
        return values


class _Field:
    """A field with fields of its own, or an array: a view into the values of its device."""

    __slots__ = ("_values", "_tree")

    def __init__(self, values, tree):
        object.__setattr__(self, "_values", values)
        object.__setattr__(self, "_tree", tree)

    def _find(self, key):
        if isinstance(key, int) and key < 0:
            key += len(self._tree)
        if key not in self._tree:
            raise AttributeError(f"found no field '{key}', allowed: {', '.join(map(str, self._tree))}")
        return self._tree[key]

    def _get(self, key):
        found = self._find(key)
        return _Field(self._values, found) if isinstance(found, dict) else self._values[found]

    def _set(self, key, value):
        found = self._find(key)
        if not isinstance(found, dict):
            self._values[found] = value
            return
        if len(value) != len(found):
            raise ValueError(f"found {len(value)} values for '{key}', allowed: {len(found)}")
        field = _Field(self._values, found)
        for inner, each in zip(found, value):
            field._set(inner, each)

    def __getattr__(self, name):
        return self._get(name)

    def __setattr__(self, name, value):
        self._set(name, value)

    def __getitem__(self, index):
        try:
            return self._get(index)
        except AttributeError as error:
            raise IndexError(str(error)) from None

    def __setitem__(self, index, value):
        self._set(index, value)

    def __len__(self):
        return len(self._tree)

    def __iter__(self):
        return (self._get(key) for key in self._tree)

    def __eq__(self, other):
        return list(self) == list(other)

    def __repr__(self):
        return repr(list(self))


class Device(list):
    """The values of a device in the order in which they travel, and its fields as attributes: `wheels.left = 2.0`,
    `proximity.value[3]`, `arms.left.elbow`, `camera.blobs[0].distance`; also by their text, `arms["left.elbow"]`."""

    def __init__(self, values, names):
        super().__init__(names.named(list(values)))
        object.__setattr__(self, "_names", names)

    def take(self, values):
        """Replaces all values; who holds the device sees the new ones."""
        super().__setitem__(slice(None), self._names.named(values))

    def _place(self, name):
        field = _Field(self, self._names.tree)
        parts = _parts(name)
        for part in parts[:-1]:
            field = field._get(part)
        return field, parts[-1]

    def __getattr__(self, name):
        return _Field(self, self._names.tree)._get(name)

    def __setattr__(self, name, value):
        _Field(self, self._names.tree)._set(name, value)

    def __getitem__(self, key):
        if isinstance(key, str):
            field, last = self._place(key)
            return field._get(last)
        return super().__getitem__(key)

    def __setitem__(self, key, value):
        if isinstance(key, str):
            field, last = self._place(key)
            field._set(last, value)
        else:
            super().__setitem__(key, value)

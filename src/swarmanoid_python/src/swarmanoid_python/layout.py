"""Encodes devices as bytes, by the layout that the space reports: "f8 f8" is two doubles, "(u1 f4)* b1" a list of pairs
and a boolean. The encoding is defined in swarmanoid_interface/device_type.hpp: little-endian, without padding, a list as
its length (4 bytes) and its elements."""

import operator
import re
import struct

_LETTERS = {"f4": "f", "f8": "d", "u1": "B", "u2": "H", "u4": "I", "u8": "Q", "i1": "b", "i2": "h", "i4": "i", "i8": "q",
            "b1": "?"}
_ALLOWED = {"f": "a number of single precision", "d": "a number", "?": "True, False, 0 or 1"}
for _bits, _unsigned, _signed in (8, "B", "b"), (16, "H", "h"), (32, "I", "i"), (64, "Q", "q"):
    _ALLOWED[_unsigned] = f"a whole number from 0 to {2 ** _bits - 1}"
    _ALLOWED[_signed] = f"a whole number from {-2 ** (_bits - 1)} to {2 ** (_bits - 1) - 1}"


def _is_truth_value(value):
    kind = type(value)
    if kind is bool or kind.__module__ == "numpy" and kind.__name__ in ("bool_", "bool"):  # numpy may not be installed
        return True
    try:
        return operator.index(value) in (0, 1)
    except TypeError:
        return False


def _pack_one(letter, value):
    if letter == "?" and not _is_truth_value(value):  # struct converts any object to bool: "no" would be True
        raise struct.error
    return struct.pack("<" + letter, value)


def _pack(letters, values, names):
    try:
        if "?" in letters:
            return b"".join(_pack_one(letter, value) for letter, value in zip(letters[1:], values))
        return struct.pack(letters, *values)
    except (struct.error, OverflowError):
        for i, (letter, value) in enumerate(zip(letters[1:], values)):
            try:
                _pack_one(letter, value)
            except (struct.error, OverflowError):
                name = names[i] + ": " if i < len(names) else ""
                raise ValueError(f"{name}found {value!r}, allowed: {_ALLOWED[letter]}") from None
        raise


class Layout:
    """Reads and writes the fields of one device as a flat list of values; a list of structs is a list of tuples."""

    def __init__(self, text):
        self._fields = []  # struct formats, and layouts of lists
        for inner, word in re.findall(r"\(([^()]*)\)\*|(\S+)", text):
            if inner:
                self._fields.append(Layout(inner))
            elif word not in _LETTERS:
                raise ValueError(f"found '{word}' in the layout '{text}', allowed: {', '.join(_LETTERS)}, (...)*")
            elif self._fields and isinstance(self._fields[-1], str):
                self._fields[-1] += _LETTERS[word]
            else:
                self._fields.append("<" + _LETTERS[word])

    def read(self, data, position=0):
        """@return the values, and the position after them"""
        values = []
        for field in self._fields:
            if isinstance(field, str):
                values.extend(struct.unpack_from(field, data, position))
                position += struct.calcsize(field)
                continue
            (count,) = struct.unpack_from("<I", data, position)
            position += 4
            elements = []
            for _ in range(count):
                element, position = field.read(data, position)
                elements.append(tuple(element))
            values.append(elements)
        return values, position

    def write(self, values, names=()):
        """@param names of the values, for messages; @raise ValueError for a wrong number of values, or a value that does
        not fit its field"""
        values = list(values)
        count = sum(len(field) - 1 if isinstance(field, str) else 1 for field in self._fields)
        if len(values) != count:
            raise ValueError(f"found {len(values)} values, allowed: {count}")
        data = b""
        place = 0
        for field in self._fields:
            if isinstance(field, str):
                end = place + len(field) - 1
                data += _pack(field, values[place:end], names[place:end])
                place = end
            else:
                elements = values[place]
                data += struct.pack("<I", len(elements)) + b"".join(field.write(element) for element in elements)
                place += 1
        return data

    def initial(self):
        """@return initial values: numbers are 0, lists are empty"""
        values = []
        for field in self._fields:
            values.extend([0] * (len(field) - 1) if isinstance(field, str) else [[]])
        return values

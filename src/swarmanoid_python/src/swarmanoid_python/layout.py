"""Devices as bytes, by the layout that the space tells: "f8 f8" is two doubles, "(u1 f4)* b1" a list of pairs and a truth
value. swarmanoid_interface/device_type.hpp says how they are written: little-endian, without padding, a list as its
length (4 bytes) and its elements."""

import re
import struct

_LETTERS = {"f4": "f", "f8": "d", "u1": "B", "u2": "H", "u4": "I", "u8": "Q", "i1": "b", "i2": "h", "i4": "i", "i8": "q",
            "b1": "?"}


class Layout:
    """Reads and writes the fields of one device: a list of values, in which a list of structs is a list of tuples."""

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
        """@return the values, and the position behind them"""
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

    def write(self, values):
        data = b""
        rest = list(values)
        for field in self._fields:
            if isinstance(field, str):
                count = len(field) - 1
                data += struct.pack(field, *rest[:count])
                rest = rest[count:]
            else:
                elements = rest.pop(0)
                data += struct.pack("<I", len(elements)) + b"".join(field.write(element) for element in elements)
        if rest:
            raise ValueError(f"found {len(values)} values, allowed: {len(values) - len(rest)}")
        return data

    def initial(self):
        """Every number 0, every list empty."""
        values = []
        for field in self._fields:
            values.extend([0] * (len(field) - 1) if isinstance(field, str) else [[]])
        return values

"""Names of device fields, as the space reports them: "left right", "value[0] value[1] ...". A list is followed by the
names of its elements in parentheses, "blobs(color.red distance) overflowed"."""

import difflib
import re

_WORD, _INDEX = r"[^.\[\]]+", r"\[(?:0|[1-9][0-9]*)\]"
_NAME = re.compile(rf"(?:{_WORD}|{_INDEX})(?:\.{_WORD}|{_INDEX})*")
_PART = re.compile(r"([^.\[\]]+)|\[([0-9]+)\]")


class UnknownName(AttributeError, KeyError):
    """No device or field has that name. Both an AttributeError and a KeyError, so that `hasattr`, `in` and `get` work as
    usual."""

    def __init__(self, where, found, allowed):
        allowed = [str(name) for name in allowed]
        close = difflib.get_close_matches(str(found), allowed, 1)
        super().__init__(f"{where} '{found}', allowed: {', '.join(allowed) or 'none'}"
                         + (f"; did you mean '{close[0]}'?" if close else ""))

    def __str__(self):  # KeyError would quote the text
        return self.args[0]


def parts(name):
    """Splits "joints[2].angle" into ["joints", 2, "angle"]. @return an empty list for invalid names such as "left..elbow"
    and "value[00]" """
    if not _NAME.fullmatch(name):
        return []
    return [word or int(index) for word, index in _PART.findall(name)]


class Fields(dict):
    """The fields of a device, or of one of its fields, by name, or by number for an array. Each maps to the index of its
    value among all values of the device, or to nested Fields."""

    def __init__(self, path, text=""):
        """@param path for messages, such as "handbot_arms/left"; @param text names of the fields"""
        super().__init__()
        self.path = path
        self.names = []  # name of each value, by index: "handbot_arms/left.elbow"
        self.lists = {}  # index of a list -> Fields of one element
        for name, inner in re.findall(r"([^\s()]+)(?:\(([^()]*)\))?", text):
            place = len(self.names)
            self.names.append(f"{path}/{name}")
            path_of_name = parts(name)
            if not path_of_name:
                raise ValueError(f"{path}: found the name '{name}', allowed: names such as 'left.elbow' and 'value[0]'")
            self._insert(path_of_name, place)
            if inner:
                self.lists[place] = Fields(f"{path}/{name}[]", inner)

    def _insert(self, path, place):
        first, rest = path[0], path[1:]
        if not rest:
            self[first] = place
            return
        shown = f"{self.path}[{first}]" if isinstance(first, int) else f"{self.path}/{first}"
        if first not in self:
            self[first] = Fields(shown)
        self[first]._insert(rest, place)

    def unknown(self, name):
        """@return the error for an unknown field name"""
        return UnknownName(f"{self.path}: found no field", name, [f"[0] to [{len(self) - 1}]"] if 0 in self else self)

    def find(self, key):
        if key not in self:
            raise self.unknown(key)
        return self[key]

    def key_at(self, index):
        """@return the name of a field by its index; -1 is the last"""
        keys = list(self)
        if not -len(keys) <= index < len(keys):
            raise IndexError(f"{self.path}: found index {index}, allowed: {-len(keys)} to {len(keys) - 1}")
        return keys[index]

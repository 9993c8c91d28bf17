"""Makes experiment files that differ from valid ones in some way: a value, the structure, the text, or bytes."""

import copy
import threading
import xml.etree.ElementTree as ElementTree

import values


class Mutator:
    """Mutates the files of `sources`; the grammar describes their elements."""

    def __init__(self, grammar, sources, random):
        self._elements, self._sources, self._random = grammar, sources, random
        self._by_name = {}
        for element in grammar:
            self._by_name.setdefault(element.name, []).append(element)

    def make(self):
        """@return description of the change, and bytes of a file"""
        source = self._random.choice(sorted(self._sources))
        text = self._sources[source]
        ways = [self._change_tree] * 8 + [self._change_text, self._change_bytes]
        done, data = self._random.choice(ways)(text)
        return f"{source}: {done}", data

    # trees

    def _change_tree(self, text):
        root = ElementTree.fromstring(text)
        done = []
        for _ in range(self._random.choice([1, 1, 1, 1, 2, 6])):
            change = self._random.choice([self._give_value] * 8 + [self._insert] * 2 + [
                self._give_attribute, self._remove, self._double, self._move, self._rename])
            done.append(change(root))
        return "; ".join(done), values_in_place(ElementTree.tostring(root, encoding="unicode")).encode("utf-8", "replace")

    def _any(self, root):
        return self._random.choice(list(root.iter()))

    def _kind(self, name):
        known = [element.kind for element in self._by_name.get(name, []) if element.kind is not None]
        return self._random.choice(known) if known else None

    def _value(self, kind):
        return self._random.choice([values.bad, values.good, values.extreme])(kind, self._random)

    def _give_value(self, root):
        leaves = [element for element in root.iter() if len(element) == 0]
        element = self._random.choice(leaves)
        element.text = placeholder(self._value(self._kind(element.tag)))
        return f"{element.tag} gets a value"

    def _give_attribute(self, root):
        element = self._any(root)
        known = [kinds for entry in self._by_name.get(element.tag, []) for kinds in entry.attributes.items()]
        name, kind = self._random.choice(known or [("id", None)])
        name = name if self._random.random() < 0.8 else self._random.choice(["idd", "xml:lang", "library", "source", "quantity"])
        if name in element.attrib and self._random.random() < 0.3:
            del element.attrib[name]
            return f"{element.tag} loses {name}"
        element.set(name, placeholder(self._value(kind)))
        return f"{element.tag} gets {name}"

    def _fill(self, entry, depth=0):
        element = ElementTree.Element(entry.name)
        for name, kind in entry.attributes.items():
            if self._random.random() < 0.8:
                element.set(name, placeholder(values.good(kind, self._random)))
        if entry.kind is not None:
            element.text = placeholder(self._value(entry.kind))
        for child in entry.children:
            if depth < 6 and self._random.random() < 0.6:
                element.append(self._fill(child, depth + 1))
        return element

    def _insert(self, root):
        parent = self._any(root)
        known = [child for entry in self._by_name.get(parent.tag, []) for child in entry.children]
        entry = self._random.choice(known if known and self._random.random() < 0.8 else self._elements)
        parent.insert(self._random.randint(0, len(parent)), self._fill(entry))
        return f"{entry.name} is put into {parent.tag}"

    def _pair(self, root):
        pairs = [(parent, child) for parent in root.iter() for child in parent]
        return self._random.choice(pairs) if pairs else (None, None)

    def _remove(self, root):
        parent, child = self._pair(root)
        if parent is None:
            return "nothing"
        parent.remove(child)
        return f"{child.tag} is removed"

    def _double(self, root):
        parent, child = self._pair(root)
        if parent is None:
            return "nothing"
        for _ in range(self._random.choice([1, 1, 2, 50])):
            parent.append(copy.deepcopy(child))
        return f"{child.tag} is doubled"

    def _move(self, root):
        parent, child = self._pair(root)
        other = self._any(root)
        if parent is None or other in child.iter():
            return "nothing"
        parent.remove(child)
        other.append(child)
        return f"{child.tag} is moved to {other.tag}"

    def _rename(self, root):
        element = self._any(root)
        name = self._random.choice([entry.name for entry in self._elements] + ["x", element.tag + "s"])
        done = f"{element.tag} becomes {name}"
        element.tag = name
        return done

    # text and bytes

    def _change_text(self, text):
        place = self._random.randint(0, len(text))
        piece = self._random.choice([
            "&" + "lol;" * 3, "<!DOCTYPE a [<!ENTITY b 'c'><!ENTITY d '&b;&b;'>]>", "<!-- ", "-->", "<![CDATA[", "<?xml version='9'?>",
            "<a>" * 20000, "</arena>", "&#" + "7" * 30000 + ";", "<" + "a" * 100000 + "/>", "\x00", "\x1b[2J", "\r", "<a " + "b='c' " * 20000 + "/>",
            "<?php ?>", "\ufeff", "<arena>", "=", "'", '"', "<", ">"])
        return f"{piece[:20]!r} at {place}", (text[:place] + piece + text[place:]).encode("utf-8")

    def _change_bytes(self, text):
        data = bytearray(text.encode("utf-8"))
        way = self._random.choice(["flip", "cut", "drop", "noise", "encoding", "empty"])
        if way == "flip":
            for _ in range(self._random.choice([1, 3, 30])):
                data[self._random.randrange(len(data))] ^= 1 << self._random.randrange(8)
        elif way == "cut":
            del data[self._random.randrange(len(data)):]
        elif way == "drop":
            start = self._random.randrange(len(data))
            del data[start:start + self._random.choice([1, 5, 200])]
        elif way == "noise":
            start = self._random.randrange(len(data))
            data[start:start] = self._random.randbytes(self._random.choice([1, 8, 1000]))
        elif way == "encoding":
            data = bytearray(text.encode(self._random.choice(["utf-16", "utf-32", "utf-16-be", "latin-1", "utf-8-sig"]), "replace"))
        else:
            data = bytearray(self._random.choice([b"", b"\n", b"<", b"<ahss-config/>", b"\x1f\x8b\x08", b"\x89PNG\r\n\x1a\n"]))
        return way, bytes(data)


# The tree contains placeholders, which are replaced by the raw values at the end: the tree would make these
# well-formed.
class _Words(threading.local):  # several threads make cases
    def __init__(self):
        self.known = {}


_WORDS = _Words()


def placeholder(value):
    word = f"value{len(_WORDS.known)}value"
    _WORDS.known[word] = value
    return word


def values_in_place(text):
    for word, value in _WORDS.known.items():
        text = text.replace(word, values.escaped(value))
    _WORDS.known.clear()
    return text

"""The schema of experiment files: its elements and attributes, and their values."""

import xml.etree.ElementTree as ElementTree

XS = "{http://www.w3.org/2001/XMLSchema}"


class Kind:
    """Values of an element or attribute: `base` is number, integer, boolean, name, text, color, ..., or a list of words."""

    def __init__(self, base, low=None, high=None, words=()):
        self.base, self.low, self.high, self.words = base, low, high, tuple(words)


class Element:
    """One element of the grammar. Elements with the same name in different places are separate."""

    def __init__(self, name, kind):
        self.name, self.kind, self.children, self.attributes = name, kind, [], {}


def _kind_of(node):
    if node.get("type"):
        return Kind(node.get("type"))
    restriction = node.find(f"{XS}simpleType/{XS}restriction")
    if restriction is None:
        extension = node.find(f"{XS}complexType/{XS}simpleContent/{XS}extension")
        return Kind(extension.get("base")) if extension is not None else None
    bounds = {name: restriction.find(XS + name) for name in ("minInclusive", "maxInclusive")}
    low, high = (None if bound is None else bound.get("value") for bound in bounds.values())
    words = [word.get("value") for word in restriction.findall(XS + "enumeration")]
    return Kind(restriction.get("base"), low, high, words)


def _read(node):
    element = Element(node.get("name"), _kind_of(node))
    stack = list(node)
    while stack:
        part = stack.pop()
        if part.tag == XS + "element":
            element.children.append(_read(part))
        elif part.tag == XS + "attribute":
            element.attributes[part.get("name")] = _kind_of(part)
        else:
            stack.extend(part)
    return element


def read_grammar(schema):
    """@param schema text of an XSD @return all its elements, including nested ones"""
    root = ElementTree.fromstring(schema)
    elements = [_read(node) for node in root.findall(XS + "element")]
    result = []
    while elements:
        element = elements.pop(0)
        result.append(element)
        elements.extend(element.children)
    return result

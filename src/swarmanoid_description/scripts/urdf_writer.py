"""Writes URDF: links with their inertia, visual and collision elements, and the joints between them.

Units: metres, kilograms, radians. A link's elements are placed in the link's frame; a link in its parent's.
"""
import math

ORIGIN = (0.0, 0.0, 0.0)


def number(value):
    """Formats with ten decimals: exact enough for geometry, and free of rounding noise of sines and cosines."""
    text = f"{value:.10f}".rstrip("0").rstrip(".")
    return "0" if text == "-0" else text


def numbers(values):
    return " ".join(number(value) for value in values)


def origin(xyz, rpy):
    return f'<origin xyz="{numbers(xyz)}" rpy="{numbers(rpy)}"/>'


class Shape:
    """A primitive solid at a place in its link's frame."""

    def __init__(self, geometry, xyz, rpy, material, unit_inertia):
        self.geometry = geometry
        self.xyz = xyz
        self.rpy = rpy
        self.material = material
        self.unit_inertia = unit_inertia  # principal moments about the centre, of 1 kg

    def visual(self):
        material = f'<material name="{self.material}"/>' if self.material else ""
        return f"<visual>{origin(self.xyz, self.rpy)}<geometry>{self.geometry}</geometry>{material}</visual>"

    def collision(self):
        return f"<collision>{origin(self.xyz, self.rpy)}<geometry>{self.geometry}</geometry></collision>"

    def inertial(self, mass):
        xx, yy, zz = (number(mass * moment) for moment in self.unit_inertia)
        return (f'<inertial>{origin(self.xyz, self.rpy)}<mass value="{number(mass)}"/>'
                f'<inertia ixx="{xx}" ixy="0" ixz="0" iyy="{yy}" iyz="0" izz="{zz}"/></inertial>')


def box(size, xyz=ORIGIN, material="", rpy=ORIGIN):
    x, y, z = (length * length / 12 for length in size)
    return Shape(f'<box size="{numbers(size)}"/>', xyz, rpy, material, (y + z, x + z, x + y))


def cylinder(radius, length, xyz=ORIGIN, material="", rpy=ORIGIN):
    across = radius * radius / 4 + length * length / 12
    geometry = f'<cylinder radius="{number(radius)}" length="{number(length)}"/>'
    return Shape(geometry, xyz, rpy, material, (across, across, radius * radius / 2))


def disc(radius, bottom, top, material="", xy=(0.0, 0.0)):
    """An upright cylinder between two heights."""
    return cylinder(radius, top - bottom, (*xy, (bottom + top) / 2), material)


def sphere(radius, xyz=ORIGIN, material=""):
    moment = 0.4 * radius * radius
    return Shape(f'<sphere radius="{number(radius)}"/>', xyz, ORIGIN, material, (moment, moment, moment))


class Robot:
    """A robot whose root is an empty link `base_link`: kinematic libraries do not support inertia in a root."""

    def __init__(self, name, summary, materials):
        self.name = name
        self.title = name.capitalize()
        self.summary = summary
        self.abilities = []  # elements of <swarmanoid>
        self.lines = []
        for material, rgba in materials.items():
            self.lines.append(f'  <material name="{material}"><color rgba="{numbers(rgba)}"/></material>')
        self.lines.append('  <link name="base_link"/>')

    def link(self, name, parent="base_link", xyz=ORIGIN, rpy=ORIGIN, joint=None, kind="fixed", axis=None, limit="",
             visuals=(), collisions=(), mass=0.0, inertia=None):
        """Adds a link and its parent joint; `inertia` is the solid that defines the link's inertia."""
        elements = [inertia.inertial(mass)] if inertia else []
        elements += [shape.visual() for shape in visuals]
        elements += [shape.collision() for shape in collisions]
        self.lines += [f'  <joint name="{joint or name + "_joint"}" type="{kind}">',
                       f"    {origin(xyz, rpy)}",
                       f'    <parent link="{parent}"/><child link="{name}"/>']
        if axis:
            self.lines.append(f'    <axis xyz="{numbers(axis)}"/><limit {limit}/>')
        self.lines.append("  </joint>")
        if elements:
            self.lines += [f'  <link name="{name}">', *(f"    {element}" for element in elements), "  </link>"]
        else:
            self.lines.append(f'  <link name="{name}"/>')

    def camera(self, name, xyz, rpy=ORIGIN, visuals=()):
        """Adds a camera that looks along its x axis, and the frame of its pictures: z ahead, x right (REP-103)."""
        self.link(name, xyz=xyz, rpy=rpy, visuals=visuals)
        self.link(name + "_optical", parent=name, rpy=(-math.pi / 2, 0, -math.pi / 2))

    def can(self, element, **attributes):
        """Adds an element to <swarmanoid>, which describes mechanisms and LEDs to the suite."""
        values = "".join(f' {name}="{value}"' for name, value in attributes.items())
        self.abilities.append(f"    <{element}{values}/>")

    def text(self):
        return "\n".join([
            '<?xml version="1.0"?>', "<!-- Made by scripts/make_urdf.py: change it there. -->",
            f'<robot name="{self.name}">', f'  <swarmanoid title="{self.title}" summary="{self.summary}">',
            *self.abilities, "  </swarmanoid>", *self.lines, "</robot>", ""])

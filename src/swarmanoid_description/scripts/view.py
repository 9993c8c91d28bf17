#!/usr/bin/env python3
"""Opens rviz on a space, running or played from a bag: waits for its floor, and has the camera take all of it in.

    view.py [--layout FILE] [--topics /space]"""

import argparse
import itertools
import math
import os
import pathlib
import tempfile
import xml.etree.ElementTree

import rospkg
import rospy
import yaml
from visualization_msgs.msg import Marker, MarkerArray

PATIENCE = 3.0  # [s]
FIELD_OF_VIEW = 0.785  # upright, of the layout's camera unless it says otherwise [rad]
ASPECT = 1.5  # width by height of the narrowest picture that the view is made for: a window on a small display, with docks
FILLED = 0.95  # how far from the middle of the picture to its borders the space reaches ...
FILLED_ABOVE = 0.82  # ... and to the upper one: labels of those who are at the far side stand above it
NEAR = 0.003  # by the distance: what is nearer than this is cut off. Were it less, thin things would flicker far away
OURS = "swarmanoid_rviz"
LABELS = "labels"
LABEL_LINES = "label_lines"  # each from a robot's top to its label


def reach(orientation, half):
    """How far a box of these half lengths reaches from its middle along x, y and z, however it is turned [m]."""
    x, y, z, w = orientation.x, orientation.y, orientation.z, orientation.w
    rows = ((1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)),
            (2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)),
            (2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)))
    return [sum(abs(part) * length for part, length in zip(row, half)) for row in rows]


def corners_of(marker):
    """Points of the world [m] between which a marker lies."""
    if marker.points:
        return [(point.x, point.y, point.z) for point in marker.points[::2 if marker.ns == LABEL_LINES else 1]]
    place = (marker.pose.position.x, marker.pose.position.y, marker.pose.position.z)
    far = reach(marker.pose.orientation, [0.5 * length for length in (marker.scale.x, marker.scale.y, marker.scale.z)])
    return [[a + sign * b for a, b in zip(place, far)] for sign in (-1, 1)]


def extent(markers, frame="world"):
    """Lowest and highest corner [m] of the box that holds floor, terrain and all that is shown, but labels; None without a
    floor."""
    shown = [marker for marker in markers if marker.action == Marker.ADD and marker.header.frame_id == frame
             and marker.ns != LABELS]
    if not any(marker.ns in ("floor", "terrain") for marker in shown):
        return None
    columns = list(zip(*(corner for marker in shown for corner in corners_of(marker))))
    return [min(column) for column in columns], [max(column) for column in columns]


def axes(pitch, yaw):
    """Where the camera looks, and what is right and up in its picture."""
    forward = (-math.cos(yaw) * math.cos(pitch), -math.sin(yaw) * math.cos(pitch), -math.sin(pitch))
    right = (-math.sin(yaw), math.cos(yaw), 0.0)
    up = (-math.cos(yaw) * math.sin(pitch), -math.sin(yaw) * math.sin(pitch), math.cos(pitch))
    return forward, right, up


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def camera(low, high, pitch, yaw, field_of_view):
    """Focal point on the floor, and distance from it [m], of a camera that has the whole box in its picture.

    A point that is p away from the focal point, in the picture's plane, and d behind it is in the picture if
    p <= slope * (distance + d): each corner asks for a distance on each of the four sides."""
    forward, right, up = axes(pitch, yaw)
    middle = [0.5 * (a + b) for a, b in zip(low, high)]
    slope_up, slope_down = (filled * math.tan(0.5 * field_of_view) for filled in (FILLED_ABOVE, FILLED))
    slope_aside = ASPECT * slope_down
    offsets = [[a - b for a, b in zip(corner, middle)] for corner in itertools.product(*zip(low, high))]
    above = max(dot(offset, up) / slope_up - dot(offset, forward) for offset in offsets)
    below = max(-dot(offset, up) / slope_down - dot(offset, forward) for offset in offsets)
    aside = max(abs(dot(offset, right)) / slope_aside - dot(offset, forward) for offset in offsets)
    shift = (above - below) / (1.0 / slope_up + 1.0 / slope_down)  # of the picture upwards, until both ask for the same
    focus = [a + shift * b for a, b in zip(middle, up)]
    distance = max(above - shift / slope_up, aside)
    further = -focus[2] / forward[2]  # the same camera, but it turns about a point on the floor
    return [a + further * b for a, b in zip(focus, forward)], distance + further


def fit(layout, low, high):
    view = layout["Visualization Manager"]["Views"]["Current"]
    focus, distance = camera(low, high, view["Pitch"], view["Yaw"], view.get("Field of View", FIELD_OF_VIEW))
    view.update({"Distance": distance, "Focal Point": dict(zip("XYZ", focus)),
                 "Near Clip Distance": max(0.01, NEAR * distance)})


def plugin_of(part):
    """The package whose library makes a panel, a tool or a display of the layout."""
    return part["Class"].partition("/")[0]


def has_library(package):
    """Whether it is built: those that need what rviz is built with are not, where that is missing."""
    folders = os.environ.get("CMAKE_PREFIX_PATH", "").split(":")
    return any((pathlib.Path(folder) / f"lib/lib{package}.so").exists() for folder in folders)


def address(layout, space):
    """Our own panels and tools speak to this space, unless the layout names another one; without their library they are left out,
    for rviz would show an error."""
    manager = layout["Visualization Manager"]
    for owner, parts in ((layout, "Panels"), (manager, "Tools")):
        owner[parts] = [part for part in owner.get(parts) or [] if plugin_of(part) != OURS or has_library(OURS)]
        for part in owner[parts]:
            if plugin_of(part) == OURS:
                part.setdefault("Space", space)


def camera_places(experiment):
    """The viewpoints that an experiment file gives its <opengl_render> (thesis 4.2), as saved views of rviz. Units as there: m,
    degrees. One at the origin stands for the whole arena, which the view shows anyway."""
    try:
        root = xml.etree.ElementTree.parse(experiment).getroot()
    except (OSError, xml.etree.ElementTree.ParseError):
        return []  # on another computer
    given = {tag.tag: tag.text for tag in root.iterfind(".//opengl_render/*")}
    views = []
    for number in range(10):
        texts = [given.get(f"camera_view_{part}_{number}") for part in ("XYZ", "HPR")]
        try:
            position, angles = ([float(word) for word in text.split(",")] for text in (texts[0] or "", texts[1] or "0, 0, 0"))
            heading, pitch, roll = (math.radians(angle) for angle in angles)
        except ValueError:
            continue  # not given, or of a library of somebody else's, which may mean something else by it
        if any(position):
            views.append({"Class": "rviz/FPS", "Name": f"camera {number}", "Target Frame": "world", "Near Clip Distance": 0.01,
                          "Position": dict(zip("XYZ", position)), "Yaw": heading, "Pitch": -pitch, "Roll": roll})
    return views


def save_views(layout, views):
    """Adds those whose names the layout does not have."""
    places = layout["Visualization Manager"]["Views"]
    saved = places.get("Saved") or []
    names = {view.get("Name") for view in saved}
    places["Saved"] = saved + [view for view in views if view["Name"] not in names]


def floor_markers(topics):
    """All that does not move; a space's first message may be about another run."""
    while True:
        markers = rospy.wait_for_message(topics + "/markers_static", MarkerArray).markers
        if extent(markers) is not None:
            return markers


def moving_markers(topics):
    try:
        return rospy.wait_for_message(topics + "/markers", MarkerArray, PATIENCE).markers
    except rospy.ROSException:
        return []


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    share = pathlib.Path(rospkg.RosPack().get_path("swarmanoid_description"))
    parser.add_argument("--layout", type=pathlib.Path, default=share / "rviz/space.rviz", help="rviz layout to start from")
    parser.add_argument("--topics", default="/space", help="the space's name")
    arguments, remappings = parser.parse_known_args()
    layout = yaml.safe_load(arguments.layout.read_text())
    rospy.init_node("view", disable_rostime=True)  # time may stand still
    address(layout, arguments.topics)
    fit(layout, *extent(floor_markers(arguments.topics) + moving_markers(arguments.topics)))
    save_views(layout, camera_places(rospy.get_param(arguments.topics + "/experiment", "")))  # once the space is there
    rospy.signal_shutdown("rviz takes over")
    file = pathlib.Path(tempfile.mkdtemp(prefix="swarmanoid_view_")) / "space.rviz"
    file.write_text(yaml.safe_dump(layout))
    os.execvp("rviz", ["rviz", "-d", str(file), *remappings])


if __name__ == "__main__":
    main()

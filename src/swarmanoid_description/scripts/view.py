#!/usr/bin/env python3
"""Opens rviz on a space, running or played from a bag: waits for its floor, and fits the camera to the whole arena.

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
FIELD_OF_VIEW = 0.785  # vertical, default of the layout's camera [rad]
ASPECT = 1.5  # width by height of the narrowest supported picture: a window on a small display, with docks
FILLED = 0.95  # extent of the space, as a fraction of the way from the centre of the picture to its borders ...
FILLED_ABOVE = 0.82  # ... and to the upper border: labels of entities at the far side need space above it
NEAR = 0.003  # near clip plane, as a fraction of the distance; if smaller, thin shapes far away would flicker
OURS = "swarmanoid_rviz"
LABELS = "labels"
LABEL_LINES = "label_lines"  # each from a robot's top to its label


def reach(orientation, half):
    """Half lengths of the axis-aligned bounding box of a rotated box with these half lengths [m]."""
    x, y, z, w = orientation.x, orientation.y, orientation.z, orientation.w
    rows = ((1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)),
            (2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)),
            (2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)))
    return [sum(abs(part) * length for part, length in zip(row, half)) for row in rows]


def corners_of(marker):
    """Points that span the bounding box of a marker, in W [m]."""
    if marker.points:
        return [(point.x, point.y, point.z) for point in marker.points[::2 if marker.ns == LABEL_LINES else 1]]
    place = (marker.pose.position.x, marker.pose.position.y, marker.pose.position.z)
    far = reach(marker.pose.orientation, [0.5 * length for length in (marker.scale.x, marker.scale.y, marker.scale.z)])
    return [[a + sign * b for a, b in zip(place, far)] for sign in (-1, 1)]


def extent(markers, frame="world"):
    """Lowest and highest corner [m] of the bounding box of floor, terrain and all other markers except labels; None without
    floor or terrain."""
    shown = [marker for marker in markers if marker.action == Marker.ADD and marker.header.frame_id == frame
             and marker.ns != LABELS]
    if not any(marker.ns in ("floor", "terrain") for marker in shown):
        return None
    columns = list(zip(*(corner for marker in shown for corner in corners_of(marker))))
    return [min(column) for column in columns], [max(column) for column in columns]


def axes(pitch, yaw):
    """@return unit vectors forward, right and up of the camera, in W"""
    forward = (-math.cos(yaw) * math.cos(pitch), -math.sin(yaw) * math.cos(pitch), -math.sin(pitch))
    right = (-math.sin(yaw), math.cos(yaw), 0.0)
    up = (-math.cos(yaw) * math.sin(pitch), -math.sin(yaw) * math.sin(pitch), math.cos(pitch))
    return forward, right, up


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def camera(low, high, pitch, yaw, field_of_view):
    """Focal point on the floor, and distance from it [m], of a camera that sees the whole box.

    A point at distance p from the focal point in the picture's plane, and d behind that plane, is in the picture if
    p <= slope * (distance + d), so each corner requires a distance on each of the four sides."""
    forward, right, up = axes(pitch, yaw)
    middle = [0.5 * (a + b) for a, b in zip(low, high)]
    slope_up, slope_down = (filled * math.tan(0.5 * field_of_view) for filled in (FILLED_ABOVE, FILLED))
    slope_aside = ASPECT * slope_down
    offsets = [[a - b for a, b in zip(corner, middle)] for corner in itertools.product(*zip(low, high))]
    above = max(dot(offset, up) / slope_up - dot(offset, forward) for offset in offsets)
    below = max(-dot(offset, up) / slope_down - dot(offset, forward) for offset in offsets)
    aside = max(abs(dot(offset, right)) / slope_aside - dot(offset, forward) for offset in offsets)
    shift = (above - below) / (1.0 / slope_up + 1.0 / slope_down)  # of the picture upwards, so that both require the same distance
    focus = [a + shift * b for a, b in zip(middle, up)]
    distance = max(above - shift / slope_up, aside)
    further = -focus[2] / forward[2]  # same view, with the focal point on the floor
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
    """Whether the package's library is built; packages that depend on rviz are skipped where rviz is missing."""
    folders = os.environ.get("CMAKE_PREFIX_PATH", "").split(":")
    return any((pathlib.Path(folder) / f"lib/lib{package}.so").exists() for folder in folders)


def address(layout, space):
    """Connects our panels and tools to this space, unless the layout names another one. Without their library they are removed,
    since rviz would show an error."""
    manager = layout["Visualization Manager"]
    for owner, parts in ((layout, "Panels"), (manager, "Tools")):
        owner[parts] = [part for part in owner.get(parts) or [] if plugin_of(part) != OURS or has_library(OURS)]
        for part in owner[parts]:
            if plugin_of(part) == OURS:
                part.setdefault("Space", space)


def camera_places(experiment):
    """The viewpoints of <opengl_render> in an experiment file (thesis 4.2), as saved views of rviz. The file has metres and
    degrees. A viewpoint at the origin means the default view of the whole arena and is skipped."""
    try:
        root = xml.etree.ElementTree.parse(experiment).getroot()
    except (OSError, xml.etree.ElementTree.ParseError):
        return []  # for example if the run is on another computer
    given = {tag.tag: tag.text for tag in root.iterfind(".//opengl_render/*")}
    views = []
    for number in range(10):
        texts = [given.get(f"camera_view_{part}_{number}") for part in ("XYZ", "HPR")]
        try:
            position, angles = ([float(word) for word in text.split(",")] for text in (texts[0] or "", texts[1] or "0, 0, 0"))
            heading, pitch, roll = (math.radians(angle) for angle in angles)
        except ValueError:
            continue  # missing, or of another library's <opengl_render> with another meaning
        if any(position):
            views.append({"Class": "rviz/FPS", "Name": f"camera {number}", "Target Frame": "world", "Near Clip Distance": 0.01,
                          "Position": dict(zip("XYZ", position)), "Yaw": heading, "Pitch": -pitch, "Roll": roll})
    return views


def save_views(layout, views):
    """Adds the views whose names are not in the layout."""
    places = layout["Visualization Manager"]["Views"]
    saved = places.get("Saved") or []
    names = {view.get("Name") for view in saved}
    places["Saved"] = saved + [view for view in views if view["Name"] not in names]


def floor_markers(topics):
    """Waits for the static markers with a floor; a space's first message may belong to another run."""
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
    rospy.init_node("view", disable_rostime=True)  # simulated time may be paused
    address(layout, arguments.topics)
    fit(layout, *extent(floor_markers(arguments.topics) + moving_markers(arguments.topics)))
    save_views(layout, camera_places(rospy.get_param(arguments.topics + "/experiment", "")))  # set once the space runs
    rospy.signal_shutdown("rviz takes over")
    file = pathlib.Path(tempfile.mkdtemp(prefix="swarmanoid_view_")) / "space.rviz"
    file.write_text(yaml.safe_dump(layout))
    os.execvp("rviz", ["rviz", "-d", str(file), *remappings])


if __name__ == "__main__":
    main()

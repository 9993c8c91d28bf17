#!/usr/bin/env python3
"""Opens rviz on a space, running or played from a bag: waits for its floor, and fits grid and camera to it.

    view.py [--layout FILE] [--topics /space]"""

import argparse
import math
import os
import pathlib
import tempfile

import rospkg
import rospy
import yaml
from visualization_msgs.msg import MarkerArray

PATIENCE = 3.0  # [s]
CELLS = 13  # of the grid, at the most, along the longer side


def extent(markers):
    """Lengths along x and y [m] of floor and terrain, which has the place of parts of it; None without them."""
    corners = [(marker.pose.position.x + 0.5 * marker.scale.x, marker.pose.position.y + 0.5 * marker.scale.y)
               for marker in markers if marker.ns == "floor"]
    corners += [(point.x, point.y) for marker in markers if marker.ns == "terrain" for point in marker.points]
    return (max(x for x, _ in corners), max(y for _, y in corners)) if corners else None


def floor_size(topics):
    """Lengths along x and y [m]; the floor begins at the origin."""
    while True:
        size = extent(rospy.wait_for_message(topics + "/markers_static", MarkerArray).markers)
        if size is not None:
            return size


def greatest_height(topics):
    """Of what moves [m]."""
    try:
        markers = rospy.wait_for_message(topics + "/markers", MarkerArray, PATIENCE).markers
    except rospy.ROSException:
        return 0.0
    return max([0.0] + [point.z for marker in markers for point in [marker.pose.position, *marker.points]])


def cell_length(side):
    """The smallest of 0.1, 0.2, 0.5, 1, 2, 5, ... that divides the side into few enough cells [m]."""
    lengths = [digit * 10.0**power for power in range(-1, 4) for digit in (1, 2, 5)]
    return next((length for length in lengths if side / length <= CELLS), lengths[-1])


def fit(layout, width, depth, height):
    """Looks from the south, as on a map that was tilted; leaves room above the floor where somebody flies."""
    side = max(width, depth)
    cell = cell_length(side)
    count = math.floor(side / cell + 1e-6)
    manager = layout["Visualization Manager"]
    for display in manager["Displays"]:
        if display["Class"] == "rviz/Grid":
            middle = 0.5 * count * cell
            display.update({"Cell Size": cell, "Plane Cell Count": count, "Offset": {"X": middle, "Y": middle, "Z": 0}})
    flies = height > 0.2 * side
    manager["Views"]["Current"].update({
        "Distance": (1.5 if flies else 1.35) * max(depth, 0.8 * width) + 0.2,
        "Focal Point": {"X": 0.5 * width, "Y": (0.52 if flies else 0.45) * depth, "Z": 0.06 * side if flies else 0.0},
    })


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    share = pathlib.Path(rospkg.RosPack().get_path("swarmanoid_description"))
    parser.add_argument("--layout", type=pathlib.Path, default=share / "rviz/space.rviz", help="rviz layout to start from")
    parser.add_argument("--topics", default="/space", help="the space's name")
    arguments, remappings = parser.parse_known_args()
    layout = yaml.safe_load(arguments.layout.read_text())
    rospy.init_node("view", disable_rostime=True)  # time may stand still
    fit(layout, *floor_size(arguments.topics), greatest_height(arguments.topics))
    rospy.signal_shutdown("rviz takes over")
    file = pathlib.Path(tempfile.mkdtemp(prefix="swarmanoid_view_")) / "space.rviz"
    file.write_text(yaml.safe_dump(layout))
    os.execvp("rviz", ["rviz", "-d", str(file), *remappings])


if __name__ == "__main__":
    main()

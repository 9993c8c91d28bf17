#!/usr/bin/env python3
"""Checks that packages, and rooms inside packages, include each other only along the arrows of docs/explanation/architecture.md,
that logic is free of ROS, that code for all robots names no robot, and that no file exceeds its maximum length."""

import os
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
MOST_LINES = 500
NAMELESS = ("swarmanoid_interface", "swarmanoid_hosts", "swarmanoid_space", "swarmanoid_engines", "swarmanoid_experiment_files",
            "swarmanoid_recording", "swarmanoid_ros")  # outside folders `devices`
COMMENT = re.compile(r"//.*|/\*.*?\*/|\w+_sample_controller|sample_\w+_controller")  # names in experiment files of the thesis
INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]')


def arrows():
    """Reads lines such as "swarmanoid_space -> swarmanoid_interface" from the architecture page."""
    text = (ROOT / "docs/explanation/architecture.md").read_text()
    allowed = {}
    for line in re.findall(r"^    (swarmanoid_\w+) -> (.+)$", text, re.M):
        allowed[line[0]] = set(re.findall(r"swarmanoid_\w+", line[1]))
    return allowed


def with_tests(allowed):
    """The packages that tests and benchmarks of each package may include: also those that do not depend on it."""
    def below(package):
        found = set()
        for other in allowed.get(package, ()):
            found |= {other} | below(other)
        return found
    return {package: {other for other in allowed if package not in below(other)} for package in allowed}


def names_above(allowed):
    """For the space, a pattern that matches the names of packages that it may not know, and of libraries of their own."""
    known = allowed["swarmanoid_space"] | {"swarmanoid_space"}
    return re.compile(r"\b(" + "|".join(sorted(set(allowed) - known)) + r"|libxml\w*|hdf5|libpng|rosbag|roscpp|box2d|ode/ode)\b", re.I)


def room_arrows():
    """Reads lines such as "swarmanoid_space/state -> models". @return by package, the rooms that each room may include"""
    text = (ROOT / "docs/explanation/architecture.md").read_text()
    allowed = {}
    for package, room, others in re.findall(r"^    (swarmanoid_\w+)/(\S+) -> (.+)$", text, re.M):
        names = [] if others == "(nothing)" else re.split(r",\s*", others)
        allowed.setdefault(package, {})[room] = {room, *names}
    return allowed


def room_of(path):
    """Folder of a source or public header in its package, such as "ros/recording", or ".". @param path in the repository"""
    package = path.parts[1]
    inside = path.parts[4:-1] if path.parts[2:4] == ("include", package) else path.parts[3:-1]
    return "/".join(inside) or "."


def included(path, name):
    """The included file, or None if it is in another package."""
    package = path.parts[1]
    if name.startswith(package + "/"):
        return pathlib.Path("src", package, "include", name)
    beside = pathlib.Path(os.path.normpath(path.parent / name))
    return beside if (ROOT / beside).exists() else None


def room_problem(path, name, rooms):
    """@return the error in that include, or None"""
    if path.parts[2] not in ("include", "src"):
        return None  # tests may include all rooms
    room = room_of(path)
    if room not in rooms:
        return f"the room {room} is not on the page"
    target = included(path, name)
    if target is not None and room_of(target) not in rooms[room]:
        return f"the room {room} must not include {room_of(target)}"
    return None


def ros_allowed(path):
    """Whether a file may use ROS: only those of swarmanoid_ros, files in a folder `ros`, nodelets and rostests may."""
    return path.parts[1] == "swarmanoid_ros" or "ros" in path.parts or "rostest" in path.parts or "nodelet" in path.name


def robot_names():
    """A pattern that matches the names of the suite's robots."""
    names = sorted(path.stem for path in ROOT.glob("src/swarmanoid_description/urdf/*.urdf"))
    return re.compile("|".join(names), re.I)


def may_name_robots(path):
    """Whether a file may name robots: devices, their topics and tests may."""
    return (path.parts[1] not in NAMELESS or path.parts[2] not in ("src", "include")
            or {"devices", "topics", "testing"} & set(path.parts))


def main():
    robots = robot_names()
    allowed = arrows()
    allowed_in_tests = with_tests(allowed)
    above = names_above(allowed)
    rooms = room_arrows()
    problems = []
    for package, arrows_of in rooms.items():
        for others in arrows_of.values():
            problems += [f"docs/explanation/architecture.md: {package} has no room {other}" for other in others - set(arrows_of)]
    if not allowed or not rooms:
        problems.append("docs/explanation/architecture.md has no arrows")
    for path in sorted(ROOT.glob("src/*/**/*")):
        if path.suffix not in (".cpp", ".hpp", ".py", ".h"):
            continue
        relative = path.relative_to(ROOT)
        package = relative.parts[1]
        may = allowed if relative.parts[2] in ("src", "include") else allowed_in_tests
        lines = path.read_text().splitlines()
        if len(lines) > MOST_LINES:
            problems.append(f"{relative}: {len(lines)} lines, allowed: {MOST_LINES}")
        for number, line in enumerate(lines, 1):
            named = None if may_name_robots(relative) else robots.search(COMMENT.sub("", line))
            if named:
                problems.append(f"{relative}:{number}: {package} must not name {named.group(0)}")
            if package == "swarmanoid_space" and above.search(line):
                problems.append(f"{relative}:{number}: the space must not know {above.search(line).group(0)}")
            found = INCLUDE.match(line)
            if not found:
                continue
            first = found.group(1).split("/")[0]
            if package in rooms:
                problem = room_problem(relative, found.group(1), rooms[package])
                if problem:
                    problems.append(f"{relative}:{number}: {problem}")
            if first.startswith("swarmanoid_") and first != package and first not in may.get(package, ()):
                problems.append(f"{relative}:{number}: {package} must not include {first}")
            if found.group(1) in ("ros/ros.h", "nodelet/nodelet.h") and not ros_allowed(relative):
                problems.append(f"{relative}:{number}: {found.group(1)} belongs into a folder ros/ or a nodelet")
    print("\n".join(problems) if problems else f"layers: {len(allowed)} packages, {sum(map(len, rooms.values()))} rooms, all includes along the arrows")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())

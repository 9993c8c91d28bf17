#!/usr/bin/env python3
"""Checks that packages include each other only along the arrows of docs/explanation/architecture.md, that logic stays free
of ROS, and that no file grows beyond its bound."""

import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
MOST_LINES = 500
INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]')


def arrows():
    """Reads lines such as "swarmanoid_space -> swarmanoid_interface" from the architecture page."""
    text = (ROOT / "docs/explanation/architecture.md").read_text()
    allowed = {}
    for line in re.findall(r"^    (swarmanoid_\w+) -> (.+)$", text, re.M):
        allowed[line[0]] = set(re.findall(r"swarmanoid_\w+", line[1]))
    return allowed


def ros_allowed(path):
    """ROS is an edge: only files in a folder `ros`, nodelets and rostests may know it."""
    return "ros" in path.parts or "rostest" in path.parts or "nodelet" in path.name


def main():
    allowed = arrows()
    problems = []
    if not allowed:
        problems.append("docs/explanation/architecture.md has no arrows")
    for path in sorted(ROOT.glob("src/*/**/*")):
        if path.suffix not in (".cpp", ".hpp", ".py", ".h"):
            continue
        relative = path.relative_to(ROOT)
        package = relative.parts[1]
        lines = path.read_text().splitlines()
        if len(lines) > MOST_LINES:
            problems.append(f"{relative}: {len(lines)} lines, allowed: {MOST_LINES}")
        for number, line in enumerate(lines, 1):
            found = INCLUDE.match(line)
            if not found:
                continue
            first = found.group(1).split("/")[0]
            if first.startswith("swarmanoid_") and first != package and first not in allowed.get(package, ()):
                problems.append(f"{relative}:{number}: {package} must not include {first}")
            if found.group(1) in ("ros/ros.h", "nodelet/nodelet.h") and not ros_allowed(relative):
                problems.append(f"{relative}:{number}: {found.group(1)} belongs into a folder ros/ or a nodelet")
    print("\n".join(problems) if problems else f"layers: {len(allowed)} packages, all includes along the arrows")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())

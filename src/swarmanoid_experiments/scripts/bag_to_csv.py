#!/usr/bin/env python3
"""Turns a recorded bag into a table of poses (CSV), the story of the run (events, CSV) and a picture of the trajectories.

    bag_to_csv.py RUN.bag [--out FOLDER]

Reads the topics /space/world_state and /space/events, however the bag was made. Writes poses.csv, events.csv and
trajectories.png."""

import argparse
import csv
import math
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
import rosbag  # noqa: E402


KINDS = ("attached", "released", "controller_failed", "left_arena", "overflow", "spawned", "deleted", "moved",
         "intervention", "finished", "handed_over", "handover_refused",
         "engine_trouble")


def yaw(q):
    return math.atan2(2.0 * (q.w * q.z + q.x * q.y), 1.0 - 2.0 * (q.y * q.y + q.z * q.z))


def read(bag_file, poses_file, events_file):
    """Writes both tables; returns the paths and colours of everything that moves."""
    paths, colors, gaps, last_tick = {}, {}, 0, None
    with rosbag.Bag(str(bag_file)) as bag, open(poses_file, "w", newline="") as poses, open(
        events_file, "w", newline=""
    ) as events:
        pose_table, event_table = csv.writer(poses), csv.writer(events)
        pose_table.writerow(["tick", "time_s", "name", "type", "x_m", "y_m", "z_m", "yaw_rad", "engine", "gripped"])
        event_table.writerow(["tick", "time_s", "kind", "entity", "other", "text"])
        for topic, message, _ in bag.read_messages(topics=["/space/world_state", "/space/events"]):
            time = message.header.stamp.to_sec()
            if topic.endswith("events"):
                event_table.writerow(
                    [message.tick, time, KINDS[message.kind], message.entity, message.other, message.text]
                )
                continue
            gaps += last_tick is not None and message.tick > last_tick + 1
            last_tick = message.tick
            for i, name in enumerate(message.names):
                p = message.poses[i].position
                pose_table.writerow([message.tick, time, name, message.types[i], p.x, p.y, p.z,
                                     yaw(message.poses[i].orientation), message.engines[i], message.gripped[i]])
                if message.types[i] not in ("block", "light"):
                    paths.setdefault(name, []).append((p.x, p.y))
                    c = message.colors[i]
                    if "prey" in message.types[i]:
                        colors[name] = (c.r, c.g, c.b)
    return paths, colors, gaps


def draw(paths, colors, picture, title):
    figure, axes = plt.subplots(figsize=(7, 7))
    for name, path in sorted(paths.items()):
        xs, ys = zip(*path)
        (line,) = axes.plot(xs, ys, linewidth=1.2, label=name if len(paths) <= 20 else None, color=colors.get(name))
        axes.plot(xs[:1], ys[:1], "o", color=line.get_color())
        axes.plot(xs[-1:], ys[-1:], "s", color=line.get_color())
    axes.set_aspect("equal")
    axes.set_xlabel("x [m]")
    axes.set_ylabel("y [m]")
    axes.set_title(f"{title} (circle: start, square: end)")
    axes.set_facecolor("0.93")
    if len(paths) <= 20:
        axes.legend(loc="best", fontsize="small")
    figure.savefig(picture, dpi=110, bbox_inches="tight")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("bag", type=pathlib.Path)
    parser.add_argument("--out", type=pathlib.Path, default=pathlib.Path("."), help="folder for the results")
    arguments = parser.parse_args()
    if not arguments.bag.is_file():
        sys.exit(f"{arguments.bag}: no such file")
    arguments.out.mkdir(parents=True, exist_ok=True)
    paths, colors, gaps = read(arguments.bag, arguments.out / "poses.csv", arguments.out / "events.csv")
    if not paths:
        sys.exit(f"{arguments.bag}: holds no /space/world_state")
    draw(paths, colors, arguments.out / "trajectories.png", arguments.bag.stem)
    print(f"{arguments.out}: poses.csv, events.csv, trajectories.png; {gaps} gaps in the ticks")


if __name__ == "__main__":
    main()

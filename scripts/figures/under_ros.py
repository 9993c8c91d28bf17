"""Figures of the experiment under roslaunch."""

import contextlib
import os
import pathlib
import shutil
import subprocess
import tempfile
import time

import rosbag

from launched import TIMEOUT, Launched
from table import ROOT, run


def speed(table):
    """Speed of each seed, once without ROS and once as a step of the launched space, timed by the caller of the service."""
    alone_ticks = alone_s = ros_ticks = ros_s = 0.0
    with Launched() as space:
        listeners = space.subscribers()
        for seed in range(1, 101):
            summary = run("object_retrieval", "--seed", seed)
            alone_ticks += summary["ticks"]
            alone_s += summary["wall_s"]
            space.reset(seed=seed)
            ticks, seconds = space.run_to_end()
            ros_ticks += ticks
            ros_s += seconds
    alone, under_ros = alone_ticks / alone_s, ros_ticks / ros_s
    table.add("object retrieval under roslaunch, real_time_factor:=0, nobody subscribed (`~step` to the end, seeds 1-100)",
              "at least half of the headless ticks/s",
              f"{under_ros:,.0f} ticks/s; headless {alone:,.0f}; {under_ros / alone:.0%}; {len(listeners)} topics heard",
              under_ros >= 0.5 * alone and ros_ticks == alone_ticks and not listeners)


def recording(table):
    """Records ten runs into one bag, and searches it for gaps."""
    lengths, wall_s = [], 0.0
    with Launched("record:=run.bag") as space:
        for seed in range(1, 11):
            space.reset(seed=seed)
            ticks, seconds = space.run_to_end()
            lengths.append(ticks)
            wall_s += seconds
        space.stop()
        states, stamps = [], []
        with rosbag.Bag(str(space.path / "run.bag")) as bag:
            for topic, message, _ in bag.read_messages(["/space/world_state", "/tf"]):
                if topic == "/tf":
                    stamps.append(message.transforms[0].header.stamp)
                else:
                    states.append((message.run, message.tick, message.header.stamp))
    # run 0 was reset before its first tick
    expected = [(0, 0)] + [(i + 1, tick) for i, ticks in enumerate(lengths) for tick in range(ticks + 1)]
    missing = len(set(expected) - {(number, tick) for number, tick, _ in states})
    missing_tf = len({stamp for _, _, stamp in states} - set(stamps))
    speed_seen = sum(lengths) / wall_s
    table.add("the same with record:=true, `/tf` and world state every tick", "at least 1,000 ticks/s, no tick missing",
              f"{speed_seen:,.0f} ticks/s; {len(states):,} states and {len(stamps):,} `/tf` in the bag, "
              f"{missing} and {missing_tf} missing",
              speed_seen >= 1000 and missing == 0 and missing_tf == 0 and len(states) == len(stamps) == len(expected))


def same_bits(table):
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "alone"
        run("object_retrieval", "--seed", 11, "--hashes", file)
        expected = file.read_text()
        text = (ROOT / "src/swarmanoid_experiments/experiments/object_retrieval.xml").read_text()
        with_text = pathlib.Path(folder) / "with_text.xml"
        with_text.write_text(text.replace("</visualisations>", "<text_render id='t'><file>t.txt</file></text_render>"
                                          "<debug_render id='d'><file>d.txt</file></debug_render></visualisations>"))
        variants = {"nobody subscribed": [], "recording": ["record:=run.bag"], "text output": [f"experiment:={with_text}"]}
        same = [name for name, arguments in variants.items() if hashes_of(*arguments) == expected]
    table.add("same seed without ROS and under ROS: nobody subscribed, recording, text output",
              "equal state hash each tick", f"equal over {len(expected.splitlines())} states: {', '.join(same)}",
              len(same) == len(variants))
    what = "same seed without ROS and under ROS with rviz connected"
    if shutil.which("Xvfb") and shutil.which("rviz"):
        with_rviz, heard = hashes_with_rviz()
        table.add(what, "equal state hash each tick",
                  f"{'equal' if with_rviz == expected else 'not equal'}; rviz heard {', '.join(sorted(heard))}",
                  with_rviz == expected)
    else:
        table.add(what, "equal state hash each tick", "Xvfb or rviz is not installed", False)


def hashes_of(*arguments):
    with Launched("seed:=11", "hashes:=hashes.txt", *arguments) as space:
        space.run_to_end()
        return (space.path / "hashes.txt").read_text()


@contextlib.contextmanager
def screen():
    """A virtual screen. @return the name of the display"""
    read_end, write_end = os.pipe()
    server = subprocess.Popen(["Xvfb", "-displayfd", str(write_end), "-screen", "0", "1400x900x24", "-nolisten", "tcp"],
                              pass_fds=[write_end], stderr=subprocess.DEVNULL)
    os.close(write_end)
    try:
        with os.fdopen(read_end) as pipe:
            yield ":" + pipe.readline().strip()
    finally:
        server.terminate()
        server.wait()


def hashes_with_rviz():
    """Runs at ten times real time, slow enough for rviz to draw. @return the hashes, and the topics to which rviz subscribed"""
    wanted = {"/tf", "/tf_static", "/space/markers", "/space/markers_static"}
    with screen() as display, Launched("seed:=11", "hashes:=hashes.txt", "rviz:=true", "real_time_factor:=10",
                                       environment={"DISPLAY": display, "LIBGL_ALWAYS_SOFTWARE": "1"}) as space:
        until = time.monotonic() + TIMEOUT
        heard = set()
        while not wanted <= heard and time.monotonic() < until:
            time.sleep(0.2)
            heard = {topic for topic, nodes in space.subscribers().items() if "/rviz" in nodes}
        space.resume()
        while space.step(1).message == "it is running; pause it first":
            time.sleep(0.2)
        return (space.path / "hashes.txt").read_text(), heard & wanted

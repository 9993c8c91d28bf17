#!/usr/bin/env python3
"""Tables and picture from bags: of a real run, of runs with resets, all kinds of events; rejected input leaves no files."""

import csv
import importlib.util
import math
import pathlib
import resource
import subprocess
import unittest
from random import Random

import genpy
import rosbag
from geometry_msgs.msg import Pose
from std_msgs.msg import ColorRGBA
from swarmanoid_msgs.msg import Event, WorldState

from program_world import BAD_INPUT, FINISHED, ProgramTest

SCRIPT = pathlib.Path(__file__).resolve().parents[1] / "scripts/bag_to_csv.py"
RESULTS = ["events.csv", "poses.csv", "trajectories.png"]
KINDS = ["attached", "released", "controller_failed", "left_arena", "overflow", "spawned", "deleted", "moved",
         "intervention", "finished", "handed_over", "handover_refused", "engine_trouble", "participant_late",
         "participant_joined", "answer_refused", "intervention_refused", "fell_into_hole"]


def world_state(run, tick, names=("fb_10", "fb_2", "fb_1"), kind="footbot"):
    message = WorldState(run=run, tick=tick, names=names, types=[kind] * len(names), engines=["ground"] * len(names),
                         gripped=[""] * len(names), colors=[ColorRGBA()] * len(names), poses=[Pose() for _ in names])
    message.header.stamp = genpy.Time.from_sec(1.0 + 10.0 * run + 0.1 * tick)
    for i, pose in enumerate(message.poses):
        pose.position.x, pose.position.y, pose.orientation.w = float(i), 0.1 * tick + run, 1.0
    return message


class BagToCsvTest(ProgramTest):
    def setUp(self):
        super().setUp()
        self.bag = self.folder / "run.bag"

    def write(self, *messages):
        with rosbag.Bag(str(self.bag), "w") as bag:
            for message in messages:
                topic = "/space/events" if isinstance(message, Event) else "/space/world_state"
                bag.write(topic, message, message.header.stamp)

    def write_more(self, state):
        with rosbag.Bag(str(self.bag), "a" if self.bag.exists() else "w") as bag:
            bag.write("/space/world_state", state, state.header.stamp)

    def event(self, kind, run=0, tick=0):
        message = Event(kind=kind, run=run, tick=tick, entity="fb_1", other="prey", text="why, \"so\"")
        message.header.stamp = world_state(run, tick).header.stamp
        return message

    def convert(self, *arguments, limit=None):
        def limit_file_size():
            if limit is not None:
                resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit))

        return subprocess.run(["/usr/bin/python3", str(SCRIPT), *map(str, arguments)], cwd=self.folder, timeout=60,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, encoding="utf-8", check=False,
                              preexec_fn=limit_file_size)

    def tables(self, summary):
        """Returns the rows of poses and events as dictionaries."""
        done = self.convert("run.bag", "--out", "out")
        self.assertEqual((done.returncode, done.stdout, done.stderr),
                         (0, f"out: poses.csv, events.csv, trajectories.png; {summary}\n", ""))
        self.assertEqual(sorted(file.name for file in self.out.iterdir()), RESULTS)
        self.assertTrue((self.out / "trajectories.png").read_bytes().startswith(b"\x89PNG"))
        tables = []
        for name in ("poses.csv", "events.csv"):
            with open(self.out / name, newline="") as file:
                tables.append(list(csv.DictReader(file)))
        return tables

    def assert_bag_refused(self, message, *arguments, **options):
        """Expects a message in one line, and no new or changed files."""
        def contents():
            return {file: file.is_file() and file.read_bytes() for file in self.folder.rglob("*")}

        before = contents()
        done = self.convert(*arguments, **options)
        self.assertEqual((done.returncode, done.stdout, done.stderr), (BAD_INPUT, "", f"bag_to_csv: {message}\n"))
        self.assertEqual(contents(), before)


class TablesTest(BagToCsvTest):
    def test_a_recorded_run(self):
        done = self.call("run", self.world(visualisations=""), "--quiet", "--bag", self.bag)
        self.assertEqual(done.returncode, FINISHED, done.stderr)
        poses, events = self.tables("1 run, 0 gaps in the ticks")
        self.assertEqual([(row["run"], row["tick"], row["name"]) for row in poses],
                         [("0", str(tick), name) for tick in range(21) for name in ("fb", "wall")])
        self.assertEqual((poses[0]["time_s"], poses[0]["type"], poses[0]["x_m"], poses[0]["y_m"], poses[0]["engine"]),
                         ("0.0", "footbot", "2.0", "3.0", "ground"))
        self.assertEqual([row["time_s"] for row in poses if row["name"] == "fb"][:4], ["0.0", "0.1", "0.2", "0.3"])
        self.assertAlmostEqual(float(poses[0]["yaw_rad"]), 1.5707963, places=6)
        self.assertEqual([(row["run"], row["tick"], row["kind"], row["entity"]) for row in events],
                         [("0", "20", "finished", "")])

    def test_every_kind_of_event_has_the_name_of_its_message(self):
        self.write(world_state(0, 0), *(self.event(kind) for kind in range(len(KINDS))), self.event(200))
        _, events = self.tables("1 run, 0 gaps in the ticks")
        self.assertEqual([row["kind"] for row in events], KINDS + ["200"])
        self.assertEqual(events[0], {"run": "0", "tick": "0", "time_s": "0.0", "kind": "attached", "entity": "fb_1",
                                     "other": "prey", "text": "why, \"so\""})

    def test_resets_are_counted_from_the_beginning_of_the_bag(self):
        """The space had already been reset twice when the recording began."""
        self.write(*(world_state(run, tick) for run, ticks in ((2, 4), (3, 3)) for tick in range(ticks)),
                   self.event(Event.SPAWNED, 2, 3), self.event(Event.FINISHED, 3, 2))
        poses, events = self.tables("2 runs, 0 gaps in the ticks")
        self.assertEqual([(row["run"], row["tick"]) for row in poses if row["name"] == "fb_1"],
                         [("0", "0"), ("0", "1"), ("0", "2"), ("0", "3"), ("1", "0"), ("1", "1"), ("1", "2")])
        self.assertEqual([(row["run"], row["kind"]) for row in events], [("0", "spawned"), ("1", "finished")])

    def test_names_are_in_natural_order(self):
        self.write(world_state(0, 0))
        poses, _ = self.tables("1 run, 0 gaps in the ticks")
        self.assertEqual([row["name"] for row in poses], ["fb_1", "fb_2", "fb_10"])

    def test_gaps_are_counted_within_runs(self):
        self.write(*(world_state(run, tick) for run, tick in ((0, 0), (0, 1), (0, 5), (1, 3), (1, 9))))
        self.tables("2 runs, 2 gaps in the ticks")

    def test_tables_have_the_bytes_that_messages_have(self):
        """Compares with the messages directly: all digits, entities that appear and disappear, and NaN."""
        random = Random(1)
        for run, tick in ((4, 0), (4, 1), (4, 2), (5, 0), (5, 3)):
            state = world_state(run, tick, ["fb_10", "fb_2", "late"][:2 + tick % 2])
            state.engines, state.gripped = ["", "air", "ground"][:len(state.names)], ["prey, red", "", '"'][:len(state.names)]
            for pose in state.poses:
                pose.position.z, pose.position.x = random.gauss(0, 1), random.choice((1e-300, 1e22, math.nan, -0.0, 1 / 3))
                pose.orientation.x, pose.orientation.z, pose.orientation.w = (random.gauss(0, 1) for _ in range(3))
            self.write_more(state)
        self.tables("2 runs, 1 gaps in the ticks")
        expected = ["run,tick,time_s,name,type,x_m,y_m,z_m,yaw_rad,engine,gripped\r\n"]
        with rosbag.Bag(str(self.bag)) as bag:
            for _, state, _ in bag.read_messages("/space/world_state"):
                time = (state.header.stamp - world_state(state.run, 0).header.stamp).to_nsec() / 1e9
                order = [i for name in ("fb_2", "fb_10", "late") for i, other in enumerate(state.names) if other == name]
                for i in order:
                    p, q = state.poses[i].position, state.poses[i].orientation
                    yaw = math.atan2(2.0 * (q.w * q.z + q.x * q.y), 1.0 - 2.0 * (q.y * q.y + q.z * q.z))
                    gripped = {"prey, red": '"prey, red"', '"': '""""'}.get(state.gripped[i], state.gripped[i])
                    expected.append(f"{state.run - 4},{state.tick},{time!r},{state.names[i]},{state.types[i]},"
                                    f"{p.x!r},{p.y!r},{p.z!r},{yaw!r},{state.engines[i]},{gripped}\r\n")
        self.assertEqual((self.out / "poses.csv").read_bytes().decode(), "".join(expected))

    def test_a_world_in_which_nothing_moves(self):
        self.write(world_state(0, 0, ["wall"], "block"))
        self.tables("1 run, 0 gaps in the ticks")


class PictureTest(unittest.TestCase):
    def setUp(self):
        specification = importlib.util.spec_from_file_location("bag_to_csv", SCRIPT)
        self.module = importlib.util.module_from_spec(specification)
        specification.loader.exec_module(self.module)

    def figure(self, runs, robots):
        paths = [{f"fb_{i}": [(float(robots - i), 0.1 * tick + run) for tick in range(3)] for i in range(robots, 0, -1)}
                 for run in range(runs)]
        figure = self.module.draw(paths, {}, "run")
        figure.canvas.draw()
        return figure

    def test_the_legend_is_beside_the_axes_and_in_natural_order(self):
        for runs in (1, 2, 5):
            figure = self.figure(runs, 12)
            panels = [axes for axes in figure.axes if axes.get_visible()]
            self.assertEqual(len(panels), runs)
            legends = [axes.get_legend() for axes in figure.axes if axes.get_legend() is not None]
            self.assertEqual(len(legends), 1)
            self.assertEqual([text.get_text() for text in legends[0].get_texts()], [f"fb_{i}" for i in range(1, 13)])
            for axes in panels:
                self.assertFalse(legends[0].get_window_extent().overlaps(axes.get_window_extent()), f"{runs} runs")

    def test_each_run_has_its_panel(self):
        figure = self.figure(2, 3)
        for run, axes in enumerate(figure.axes):
            self.assertEqual(axes.get_title(), f"run, run {run} (circle: start, square: end)")
            self.assertEqual(min(line.get_ydata()[0] for line in axes.get_lines()), run)

    def test_many_robots_have_no_legend(self):
        self.assertIsNone(self.figure(1, 21).axes[0].get_legend())


class RefusalTest(BagToCsvTest):
    def test_bags_that_are_not_there_or_are_none(self):
        self.assert_bag_refused("nobody.bag: no such file", "nobody.bag", "--out", "out/deep")
        self.assert_bag_refused(f"{self.folder}: cannot be read: Is a directory", self.folder, "--out", "out")
        for content in (b"", b"some text\n", b"\xff\xfe\x00"):
            self.bag.write_bytes(content)
            self.assert_bag_refused("run.bag: found no bag, expected a file that begins with '#ROSBAG V2.0'",
                                    "run.bag", "--out", "out")

    def test_a_bag_that_is_cut_off(self):
        self.write(*(world_state(0, tick) for tick in range(50)))
        whole = self.bag.read_bytes()
        for length in (len(whole) - 1, len(whole) // 2, 13):
            self.bag.write_bytes(whole[:length])
            self.assert_bag_refused("run.bag: is not complete, its index is missing: the recording or a copy was cut "
                                    "short; 'rosbag reindex' saves what is there", "run.bag", "--out", "out")

    def test_a_bag_that_was_not_closed(self):
        with rosbag.Bag(str(self.bag), "w") as bag:
            for tick in range(50):
                bag.write("/space/world_state", world_state(0, tick))
            bag.flush()
            unfinished = self.bag.read_bytes()
        self.bag.write_bytes(unfinished)
        self.assert_bag_refused("run.bag: is not complete, its index is missing: the recording or a copy was cut short; "
                                "'rosbag reindex' saves what is there", "run.bag", "--out", "out")

    def test_a_bag_with_damaged_data_leaves_the_old_tables(self):
        self.write(*(world_state(0, tick) for tick in range(50)))
        self.assertEqual(self.convert("run.bag", "--out", "out").returncode, 0)
        data = bytearray(self.bag.read_bytes())
        middle = data.index(b"fb_10", 6000)
        data[middle - 4:middle] = b"\xff\xff\xff\x7f"  # the length of that name
        self.bag.write_bytes(data)
        done = self.convert("run.bag", "--out", "out")
        self.assertEqual((done.returncode, done.stdout), (BAD_INPUT, ""))
        self.assertRegex(done.stderr, r"(?m)^bag_to_csv: run.bag: is damaged: [^\n]+\n\Z")
        self.assertEqual(sorted(file.name for file in self.out.iterdir()), RESULTS)
        with open(self.out / "poses.csv", newline="") as file:
            self.assertEqual(len(list(csv.DictReader(file))), 150)

    def test_a_bag_without_states(self):
        self.write(self.event(Event.SPAWNED))
        self.assert_bag_refused("run.bag: holds no /space/world_state", "run.bag", "--out", "out")

    def test_a_folder_that_cannot_be_written(self):
        self.write(world_state(0, 0))
        (self.folder / "taken").write_text("")
        self.assert_bag_refused("--out: cannot make the folder 'taken': Not a directory", "run.bag", "--out", "taken")
        self.assert_bag_refused("--out: cannot make the folder '/dev/null/x': Not a directory",
                                "run.bag", "--out", "/dev/null/x")
        (self.folder / "mine/events.csv").mkdir(parents=True)
        self.assert_bag_refused("--out: cannot write mine/events.csv: Is a directory", "run.bag", "--out", "mine")

    def test_a_disk_that_is_full_leaves_the_old_tables(self):
        self.write(*(world_state(0, tick) for tick in range(100)))
        self.assertEqual(self.convert("run.bag", "--out", "out").returncode, 0)
        self.write(*(world_state(0, tick) for tick in range(2000)))
        self.assert_bag_refused("--out: cannot write into 'out': File too large", "run.bag", "--out", "out", limit=200000)


if __name__ == "__main__":
    unittest.main()

#!/usr/bin/env python3
"""`run --trajectories`: the arrays equal the run, with entities that appear and disappear, and however the run ends."""

import csv
import json
import pathlib
import resource
import signal
import subprocess
import time
import unittest

import h5py
import numpy
import swarmanoid

from program_world import BAD_INPUT, FINISHED, INTERRUPTED, STOPPED, ProgramTest

FILE = "run.h5"
MUCH = 1_000_000  # bytes, a file size that is reached only after the first rows were flushed
COMES_AND_GOES = """<interventions>
  <spawn tick="3" engines="ground"><footbot id="late"><position>8, 8, 0</position><orientation>0, 0, 0</orientation></footbot></spawn>
  <move tick="6" entity="wall"><position>6, 5, 0.25</position><orientation>0, 0, 45</orientation></move>
  <delete tick="9" entity="late"/>
</interventions>
"""


class TrajectoriesTest(ProgramTest):
    def record(self, experiment, *arguments):
        """@return summary and recording"""
        done = self.call("run", experiment, "--quiet", "--force", "--trajectories", FILE, *arguments)
        self.assertEqual(done.returncode, FINISHED, done.stderr)
        return json.loads(done.stdout), swarmanoid.load(self.folder / FILE)


class ArraysTest(TrajectoriesTest):
    def test_poses_and_readings_are_those_of_the_run(self):
        device = "footbot_proximity"
        summary, recording = self.record("diffusion", "--ticks", 40, "--seed", 3, "--record-readings", device)
        simulation = swarmanoid.Simulation("diffusion", seed=3, ticks=40)
        for row in range(41):
            robots = simulation.robots
            self.assertEqual(list(recording.names), robots.names)
            numpy.testing.assert_array_equal(recording.poses[row], robots.poses)
            numpy.testing.assert_array_equal(recording.readings[device].value[row], robots.readings[device].value)
            self.assertEqual((recording.ticks[row], recording.times[row]), (row, row / 10))
            simulation.tick()
        self.assertEqual(list(recording.readings[device].robots), list(range(100)))
        self.assertEqual(set(recording.types), {"footbot"})
        self.assertEqual((recording.state_hash, recording.seed, recording.version, recording.math_library),
                         (summary["state_hash"], 3, summary["version"], summary["math_library"]))

    def test_lists_have_counts(self):
        device = "footbot_camera"
        _, recording = self.record("object_retrieval", "--ticks", 60, "--record-readings", "all")
        simulation = swarmanoid.Simulation("object_retrieval", ticks=60)
        self.assertEqual(set(recording.readings), set(simulation.robots.readings))
        blobs, first = recording.readings[device].blobs, 0
        for row in range(61):
            there = simulation.robots.readings[device].blobs
            numpy.testing.assert_array_equal(blobs.counts[row], there.counts)
            end = first + int(there.counts.sum())
            numpy.testing.assert_array_equal(blobs.bearing[first:end], there.bearing)
            numpy.testing.assert_array_equal(blobs.color.red[first:end], there.color.red)
            first = end
            simulation.tick()
        self.assertGreater(first, 0, "there is something to see")
        self.assertEqual(len(blobs.bearing), first)

    def test_metrics_are_those_of_the_table(self):
        text = swarmanoid.Simulation("foraging").record["text"]
        table = '<visualisations><metrics_table id="m"><file>table.csv</file></metrics_table></visualisations></ahss-config>'
        (self.folder / "foraging.xml").write_text(text.replace("</ahss-config>", table))
        summary, recording = self.record("foraging.xml", "--ticks", 80)
        with open(self.folder / "table.csv", newline="") as file:
            rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
        self.assertTrue(summary["metrics"])
        for name in summary["metrics"]:
            self.assertEqual([float(row[name]) for row in rows], list(recording.metrics[name]))
            self.assertEqual(recording.result[name], summary["metrics"][name])

    def test_the_file_says_what_the_run_was(self):
        world = self.world(maxclock=500, visualisations="")
        path = "controllers.fc.parameters.fail_at"
        summary, recording = self.record(world, "--ticks", 7, "--set", f"{path}=5000", "--set", "framework.random_seed=9",
                                         "--bag", "run.bag")
        bag = swarmanoid.load(self.folder / "run.bag")
        self.assertEqual((bag.overrides, bag.seed, bag.version, bag.state_hash),
                         (recording.overrides, 9, summary["version"], summary["state_hash"]))
        self.assertEqual(recording.experiment_text, pathlib.Path(world).read_text())
        self.assertEqual(recording.overrides, (f"{path}=5000", "framework.random_seed=9"))
        self.assertEqual((recording.experiment, recording.seed, recording.complete, recording.finished, len(recording.ticks)),
                         ("world", 9, True, True, 8))
        with h5py.File(self.folder / FILE) as file:  # as read without the loader
            self.assertEqual((file.attrs["format"], file.attrs["state_hash"]), ("swarmanoid trajectories", summary["state_hash"]))
            self.assertEqual((file["pose"].attrs["unit"], file["pose"].attrs["frame"], file["time"].attrs["unit"]),
                             ("m; quaternion without unit", "W", "s"))
            self.assertEqual((file["pose"].shape, list(file["entities/name"]), file.attrs["maxclock"]), ((8, 1, 7), [b"fb"], 7))

    def test_the_run_is_the_same_with_and_without(self):
        summary, _ = self.record("object_retrieval", "--ticks", 200, "--record-readings", "all")
        without = json.loads(self.call("run", "object_retrieval", "--quiet", "--ticks", 200).stdout)
        self.assertEqual(summary["state_hash"], without["state_hash"])

    def test_who_comes_late_goes_or_is_moved(self):
        (self.folder / "what.xml").write_text(COMES_AND_GOES)
        _, recording = self.record(self.world(visualisations=""), "--interventions", "what.xml", "--bag", "run.bag")
        bag = swarmanoid.load(self.folder / "run.bag")
        self.assertEqual((recording.names, recording.types), (("fb", "late", "wall"), ("footbot", "footbot", "block")))
        numpy.testing.assert_array_equal(recording.times, bag.times)
        for column, name in enumerate(recording.names):
            other = bag.column(name)
            numpy.testing.assert_array_equal(recording.present[:, column], bag.present[:, other], name)
            numpy.testing.assert_array_equal(recording.poses[:, column], bag.poses[:, other], name)
        self.assertEqual(int(recording.present[:, 1].sum()), 6)
        self.assertEqual((recording.poses[0, 2, 0], recording.poses[-1, 2, 0]), (5.0, 6.0))
        for name in ("experiment", "experiment_text", "seed", "version", "math_library", "state_hash", "finished"):
            self.assertEqual(getattr(recording, name), getattr(bag, name), name)

    def test_a_bag_of_few_states_has_the_hash_of_the_last_one(self):
        few = '<rosbag_recorder id="b"><file>run.bag</file><every>7</every></rosbag_recorder>'
        done = self.call("run", self.world(maxclock=10, visualisations=few), "--quiet")
        bag = swarmanoid.load(self.folder / "run.bag")
        self.assertEqual((list(bag.ticks), bag.state_hash), ([0, 7], json.loads(done.stdout)["state_hash"]))

    def test_resets_are_runs(self):
        world = self.world(visualisations='<trajectory_recorder id="t"><file>run.h5</file>'
                                          "<every>2</every></trajectory_recorder>")
        simulation = swarmanoid.Simulation(world, seed=4, out=str(self.folder))
        simulation.tick(5)
        simulation.reset(seed=6)
        simulation.tick(4)
        simulation.close()
        recording = swarmanoid.load(self.folder / FILE)
        self.assertEqual((list(recording.runs), list(recording.ticks)), ([0, 0, 0, 1, 1, 1], [0, 2, 4, 0, 2, 4]))
        self.assertEqual(recording.seed, 4)
        with h5py.File(self.folder / FILE) as file:
            self.assertEqual((list(file["runs/seed"]), list(file["runs/first_row"])), ([4, 6], [0, 3]))


class EndTest(TrajectoriesTest):
    """Written data remain, however the run ends."""

    def start(self, **options):
        world = self.world(maxclock=10**9, visualisations="")
        return subprocess.Popen(["swarmanoid", "run", world, "--quiet", "--force", "--trajectories", FILE], cwd=self.folder,
                                stdout=subprocess.PIPE, stderr=subprocess.PIPE, encoding="utf-8", **options)

    def wait_for(self, size, process):
        file = self.folder / FILE
        end = time.monotonic() + 60
        while not (file.exists() and file.stat().st_size > size):
            self.assertIsNone(process.poll())
            self.assertLess(time.monotonic(), end)
            time.sleep(0.01)

    def assert_is_the_beginning(self, recording):
        """Expects the first rows of the run, complete and correct."""
        self.assertEqual(list(recording.ticks), list(range(len(recording.ticks))))
        self.assertTrue(recording.present.all())
        _, again = self.record(self.world(maxclock=10**9, visualisations=""), "--ticks", len(recording.ticks) - 1)
        numpy.testing.assert_array_equal(recording.poses, again.poses)

    def test_ctrl_c_leaves_a_complete_file(self):
        process = self.start()
        self.wait_for(MUCH, process)
        process.send_signal(signal.SIGINT)
        output, errors = process.communicate(timeout=60)
        self.assertEqual(process.returncode, INTERRUPTED, errors)
        recording, summary = swarmanoid.load(self.folder / FILE), json.loads(output)
        self.assertEqual((recording.complete, recording.finished, recording.state_hash, len(recording.ticks)),
                         (True, False, summary["state_hash"], summary["ticks"] + 1))
        self.assert_is_the_beginning(recording)

    def test_a_killed_run_leaves_what_was_flushed_and_no_whole_file(self):
        for delay in (0.0, 0.3, 1.3):
            process = self.start()
            self.wait_for(MUCH, process)
            time.sleep(delay)
            process.kill()
            process.communicate(timeout=60)
            recording = swarmanoid.load(self.folder / FILE)
            self.assertEqual((recording.complete, recording.state_hash, recording.finished), (False, None, None))
            self.assertGreater(len(recording.ticks), 0 if delay < 1.1 else 1000)
            if delay > 1.1:
                self.assert_is_the_beginning(recording)

    def test_a_file_can_be_read_while_it_is_written(self):
        process = self.start()
        self.addCleanup(process.communicate)
        self.addCleanup(process.kill)
        self.wait_for(MUCH, process)
        lengths, end = set(), time.monotonic() + 60
        while len(lengths) < 3 and time.monotonic() < end:
            recording = swarmanoid.load(self.folder / FILE)
            self.assertFalse(recording.complete)
            self.assertEqual(list(recording.ticks), list(range(len(recording.ticks))))
            self.assertTrue(recording.present.all())
            lengths.add(len(recording.ticks))
        self.assertEqual(len(lengths), 3)

    def test_a_full_disk_ends_the_run_and_keeps_what_there_is(self):
        limit = 15_000_000
        process = self.start(preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit)))
        output, errors = process.communicate(timeout=60)
        self.assertEqual(process.returncode, STOPPED)
        self.assertRegex(errors, rf"^swarmanoid: stopped in tick \d+: --trajectories: writing {self.folder}/{FILE} failed: "
                                 r"File too large\n\Z")
        self.assertFalse(json.loads(output)["finished"])
        recording = swarmanoid.load(self.folder / FILE)
        self.assertFalse(recording.complete)
        self.assertGreater(len(recording.ticks), 1000)
        self.assert_is_the_beginning(recording)


class RefusedTest(TrajectoriesTest):
    def test_what_cannot_be_recorded(self):
        world = self.world(visualisations="")
        self.assert_refused("--record-readings: found the sensor 'footbot_proximty', allowed: footbot_proximity; "
                            "did you mean 'footbot_proximity'?, or all, or none",
                            "run", "diffusion", "--trajectories", FILE, "--record-readings", "footbot_proximty")
        self.assert_refused("--record-readings: found 'all footbot_proximity', allowed: all alone, none alone, or names of sensors",
                            "run", "diffusion", "--trajectories", FILE, "--record-readings", "all footbot_proximity")
        self.assert_refused("--trajectories: found '/dev/null', which is a device or a pipe, allowed: a file, since trajectories are "
                            "read back while they are written", "run", world, "--trajectories", "/dev/null")
        self.assertEqual(self.call("run", world, "--record-readings", "all").returncode, BAD_INPUT)
        (self.folder / FILE).write_text("mine")
        done = self.call("run", world, "--trajectories", FILE)
        self.assertEqual(done.returncode, BAD_INPUT)
        self.assertIn("which is there already, allowed: another name, or --force to replace it", done.stderr)
        self.assertEqual((self.folder / FILE).read_text(), "mine")

    def test_what_cannot_be_loaded(self):
        text, other, newer = (self.folder / name for name in ("text", "other.h5", "newer.h5"))
        text.write_text("no recording")
        with h5py.File(other, "w") as file:
            file.attrs["title"] = "of somebody else"
        with h5py.File(newer, "w") as file:
            file.attrs.update({"format": "swarmanoid trajectories", "format_version": 2})
        for file, message in ((self.folder / "none", "no such file"),
                              (text, "found neither a bag nor trajectories, allowed: a file of `swarmanoid run --bag` or "
                                     "--trajectories"),
                              (other, "found an HDF5 file with 'no format', allowed: 'swarmanoid trajectories'"),
                              (newer, "found format 2, allowed: 1")):
            with self.assertRaises(swarmanoid.RecordingError) as caught:
                swarmanoid.load(file)
            self.assertEqual(str(caught.exception), f"{file}: {message}")


if __name__ == "__main__":
    unittest.main()

#!/usr/bin/python3
"""Bags of other programs are rejected by name, and metrics that are strings stay strings."""

import pathlib
import subprocess
import tempfile
import time
import unittest

import rosbag
import swarmanoid
from swarmanoid.bag_file import NUMBER

TEXTS = {"1.2.3": "1.2.3", ".": ".", "..": "..", "1.e": "1.e", "e5": "e5", "": "", "1_000": "1_000", "red": "red"}
NUMBERS = {"3": 3.0, "-0.5": -0.5, "+.5": 0.5, "2.": 2.0, "1e+22": 1e22, "1.5e-7": 1.5e-7, "-inf": float("-inf")}


class BagFileTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        subprocess.run(["swarmanoid", "run", "phototaxis", "--ticks", "3", "--quiet", "--bag", "run.bag"], cwd=cls.folder,
                       stdout=subprocess.DEVNULL, check=True)

    def rewrite(self, change):
        """@param change maps topic and message of the run's bag to new ones, or to None @return the bag with the results"""
        path = self.folder / "other.bag"
        with rosbag.Bag(str(self.folder / "run.bag")) as run, rosbag.Bag(str(path), "w") as other:
            for topic, message, stamp in run.read_messages():
                changed = change(topic, message)
                if changed is not None:
                    other.write(*changed, stamp)
        return path

    def assert_foreign(self, path):
        with self.assertRaises(swarmanoid.RecordingError) as caught:
            swarmanoid.load(path)
        self.assertEqual(str(caught.exception), f"{path}: found neither /space/world_state nor /space/events, "
                                                "expected a bag of `swarmanoid run --bag`")

    def test_a_bag_of_another_program_is_refused(self):
        self.assert_foreign(self.rewrite(lambda topic, message: ("/other" + topic, message)))
        self.assert_foreign(self.rewrite(lambda topic, message: None))

    def test_a_bag_without_states_has_the_events(self):
        recording = swarmanoid.load(self.rewrite(lambda topic, message: (topic, message) if topic == "/space/events" else None))
        self.assertEqual((len(recording.ticks), recording.events[-1].kind), (0, "finished"))

    def test_metrics_are_numbers_only_if_they_are_written_as_such(self):
        expected = {**TEXTS, **NUMBERS, "true": True, "false": False}

        def change(topic, message):
            if topic == "/space/result":
                kind = type(message.metrics[0])
                message.metrics = [kind(name=text, value=text) for text in expected]
            return topic, message

        self.assertEqual(swarmanoid.load(self.rewrite(change)).result, expected)

    def test_numbers_are_recognised_in_linear_time(self):
        start_s = time.process_time()
        self.assertIsNone(NUMBER.fullmatch("9" * 100_000 + "x"))
        self.assertLess(time.process_time() - start_s, 2.0)


if __name__ == "__main__":
    unittest.main()

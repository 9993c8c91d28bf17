#!/usr/bin/python3
"""What roslaunch itself does: bad arguments are refused before anything starts, and Ctrl-C leaves a complete bag."""

import pathlib
import signal
import time
import unittest

import rosbag

from roslaunch_process import LAUNCH_FOLDER, TIMEOUT, RoslaunchTest

LAUNCH_FILE = LAUNCH_FOLDER / "object_retrieval.launch"


class LaunchTest(RoslaunchTest):
    launch_file = LAUNCH_FILE

    def launch(self, *arguments):
        return super().launch("rviz:=false", *arguments)

    def test_a_bad_experiment_is_refused_before_anything_starts(self):
        for argument, reason in (("experiment:=object_retrievl", "did you mean 'object_retrieval'?"),
                                 ("experiment:=/nowhere/run.xml", "/nowhere/run.xml"),
                                 ("seed:=one", "one"),
                                 ("set:=framework.maxclok=3", "did you mean 'maxclock'?"),
                                 ("real_time_factor:=fast", "fast")):
            code, output = self.output_of(argument)
            self.assertNotEqual(0, code, output)
            self.assertIn(reason, output)
            self.assertNotIn("process[", output, "something was started")

    def test_what_only_the_space_can_tell_ends_the_launch(self):
        for argument, reason in (("device_topics:=fb_9", "~device_topics: found 'fb_9', allowed: all, none, fb_1"),
                                 ("tf_level:=most", "~tf/level: found 'most', allowed: auto, none, base, full"),
                                 ("record:=/nowhere/run.bag", "cannot write")):
            _, output = self.output_of(argument)
            self.assertIn(reason, output)
            self.assertRegex(output, r"process has died|exit code [1-9]", "roslaunch is not told of it")

    def test_a_failed_controller_is_in_the_exit_code(self):
        experiment = LAUNCH_FILE.parents[1] / "src/swarmanoid_experiments/test/data/failing_controller.xml"
        _, output = self.output_of(f"experiment:={experiment}", "real_time_factor:=0")
        self.assertIn("the controller of fb_2 failed", output)
        self.assertIn("exit code 3", output)

    def test_a_file_is_found_from_where_roslaunch_is_started(self):
        text = (LAUNCH_FILE.parents[1] / "src/swarmanoid_experiments/experiments/diffusion.xml").read_text()
        pathlib.Path(self.folder.name, "mine.xml").write_text(text)
        code, output = self.output_of("experiment:=mine.xml", "max_ticks:=10", "real_time_factor:=0")
        self.assertEqual(0, code)
        self.assertIn("mine, seed 1: finished after 10 ticks", output)
        self.assertIn("finished cleanly", output)

    def test_an_interrupt_leaves_a_complete_bag(self):
        bag = pathlib.Path(self.folder.name, "run.bag")
        hashes = pathlib.Path(self.folder.name, "hashes.txt")
        process = self.launch(f"record:={bag}", f"hashes:={hashes}", "real_time_factor:=5")
        until = time.monotonic() + TIMEOUT
        while (not bag.exists() or bag.stat().st_size < 10**5) and time.monotonic() < until:
            time.sleep(0.1)
        process.send_signal(signal.SIGINT)
        output, _ = process.communicate(timeout=TIMEOUT)
        last = int(hashes.read_text().splitlines()[-1].split()[0])
        self.assertGreater(last, 0, output)
        with rosbag.Bag(str(bag)) as reader:  # throws if it were not indexed
            states = [(m.tick, m.header.stamp) for _, m, _ in reader.read_messages("/space/world_state")]
            moving = [m.transforms[0].header.stamp for _, m, _ in reader.read_messages("/tf")]
        self.assertEqual(list(range(last + 1)), [tick for tick, _ in states])
        self.assertEqual([stamp for _, stamp in states], moving)


if __name__ == "__main__":
    unittest.main()

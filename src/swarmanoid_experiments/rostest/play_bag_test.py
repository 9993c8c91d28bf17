#!/usr/bin/python3
"""launch/play_bag.launch: an unreadable bag is rejected before any node starts; a valid one is played to its end."""

import pathlib
import signal
import threading
import unittest

import rosbag
from std_msgs.msg import String

from roslaunch_process import LAUNCH_FOLDER, TIMEOUT, RoslaunchTest


class PlayBagTest(RoslaunchTest):
    launch_file = LAUNCH_FOLDER / "play_bag.launch"

    def write_bag(self, name):
        file = pathlib.Path(self.folder.name, name)
        with rosbag.Bag(str(file), "w") as bag:
            bag.write("/space/experiment", String("<ahss-config/>"))
        return file

    def test_a_bag_that_cannot_be_read_is_refused_at_once_with_rviz_or_without(self):
        cut_off = self.write_bag("cut_off.bag")
        cut_off.write_bytes(cut_off.read_bytes()[:-100])
        text = pathlib.Path(self.folder.name, "text.bag")
        text.write_text("no bag\n")
        for argument, message in (
                ("bag:=/nowhere/run.bag", "/nowhere/run.bag: no such file"),
                ("bag:=run.bag", f"{self.folder.name}/run.bag: no such file"),
                (f"bag:={cut_off}", f"{cut_off}: is not complete, its index is missing: the recording or a copy was cut "
                                    "short; 'rosbag reindex' saves what is there"),
                (f"bag:={text}", f"{text}: found no bag, expected a file that begins with '#ROSBAG V2.0'")):
            for rviz in ("rviz:=true", "rviz:=false"):
                code, output = self.output_of(argument, rviz)
                self.assertNotEqual(0, code, output)
                self.assertIn(f"check_bag: {message}\n", output)
                self.assertNotIn("Traceback", output)
                self.assertNotIn("process[", output, "something was started")

    def test_a_bag_is_found_from_where_roslaunch_is_started(self):
        self.write_bag("my run.bag")
        process = self.launch("bag:=my run.bag", "rviz:=false")
        watch = threading.Timer(TIMEOUT, process.send_signal, [signal.SIGINT])
        watch.start()
        output = ""
        for line in process.stdout:
            output += line
            if "process has finished cleanly" in line:  # roslaunch itself stays, for its master
                process.send_signal(signal.SIGINT)
        watch.cancel()
        process.stdout.close()
        process.wait()
        self.assertIn(f"Opening {self.folder.name}/my run.bag", output)
        self.assertIn("[player-2] process has finished cleanly", output)


if __name__ == "__main__":
    unittest.main()

"""Shared parts of tests of external packages with a simulator under ROS."""

import contextlib
import glob
import os
import signal
import subprocess
import time
import unittest

from surroundings import run, succeed

LAUNCH = ["roslaunch", "swarmanoid_experiments", "run.launch", "rviz:=false", "real_time_factor:=0"]


@contextlib.contextmanager
def beside(command, environment):
    """A program that runs in parallel with the test, and gets a Ctrl-C if it still runs at the end."""
    program = subprocess.Popen(command, env=environment, text=True, stdin=subprocess.DEVNULL,
                               stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    try:
        yield program
    finally:
        if program.poll() is None:
            program.send_signal(signal.SIGINT)
        program.communicate(timeout=60)


class RosChecks(unittest.TestCase):
    """A test case that starts spaces paused, under roslaunch."""

    def resume(self, launch, environment, end):
        succeed(["rosservice", "call", "/space/resume"], environment)
        output, _ = launch.communicate(timeout=60)
        self.assertEqual(0, launch.returncode, output)
        self.assertIn(end, output)

    def wait_for_space(self, launch, environment):
        """Waits for the services of the space, which exist once all nodelets are loaded."""
        while run(["rosservice", "call", "/space/pause"], environment)[0] != 0:
            self.assertIsNone(launch.poll(), "roslaunch has ended")
            time.sleep(0.2)

    def maps_of_manager(self, launch_pid):
        """Files mapped by the nodelet manager that a roslaunch has started."""
        for status in glob.glob("/proc/[0-9]*/status"):
            folder = os.path.dirname(status)
            try:
                with open(status) as text, open(folder + "/cmdline") as command:
                    if f"\nPPid:\t{launch_pid}\n" in text.read() and "\0manager\0" in command.read():
                        with open(folder + "/maps") as maps:
                            return maps.read()
            except FileNotFoundError:
                continue  # a process that has just ended
        raise AssertionError("there is no nodelet manager")

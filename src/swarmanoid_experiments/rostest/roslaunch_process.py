"""Shared by the tests of roslaunch itself: a launch file, with a master on its own port."""

import contextlib
import os
import pathlib
import random
import signal
import socket
import subprocess
import tempfile
import unittest

LAUNCH_FOLDER = pathlib.Path(__file__).resolve().parents[3] / "launch"
TIMEOUT = 30.0  # [s]


def free_port():
    """Returns a port outside the range of ephemeral ports, which nodes may take before the master starts."""
    while True:
        port = random.randrange(12000, 32000)
        with contextlib.suppress(OSError), socket.socket() as probe:
            probe.bind(("localhost", port))
            return port


class RoslaunchTest(unittest.TestCase):
    """Each test has its own folder, in which roslaunch is started."""

    launch_file = None

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def start(self, *command):
        """Starts roslaunch, or a program that starts it, with a master on its own port."""
        port = free_port()
        self.master = f"http://localhost:{port}"
        environment = dict(os.environ, ROS_HOME=self.folder.name + "/ros", ROS_MASTER_URI=self.master,
                           ROS_HOSTNAME="localhost", PWD=self.folder.name, TMPDIR=self.folder.name)
        # in its own session, so that signals go to that process alone
        return subprocess.Popen([*command, "-p", str(port)], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                universal_newlines=True, env=environment, cwd=self.folder.name, start_new_session=True)

    def launch(self, *arguments, file=None):
        return self.start("roslaunch", str(file or self.launch_file), *arguments)

    def end_of(self, process):
        """Returns exit code and output; the test fails if the process does not end."""
        try:
            output, _ = process.communicate(timeout=TIMEOUT)
        except subprocess.TimeoutExpired:
            process.send_signal(signal.SIGINT)
            output, _ = process.communicate()
            self.fail(f"{process.args}: does not end:\n{output}")
        return process.returncode, output

    def output_of(self, *arguments, **more):
        return self.end_of(self.launch(*arguments, **more))

"""What tests of roslaunch itself share: a launch file, with a master on a port of its own."""

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
    """None of those that the system gives to whoever asks for any, as nodes do while the master is about to start."""
    while True:
        port = random.randrange(12000, 32000)
        with contextlib.suppress(OSError), socket.socket() as probe:
            probe.bind(("localhost", port))
            return port


class RoslaunchTest(unittest.TestCase):
    """Each test has a folder of its own, in which roslaunch is started."""

    launch_file = None

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def start(self, *command):
        """roslaunch, or a program that starts it, with a master on a port of its own."""
        port = free_port()
        self.master = f"http://localhost:{port}"
        environment = dict(os.environ, ROS_HOME=self.folder.name + "/ros", ROS_MASTER_URI=self.master,
                           ROS_HOSTNAME="localhost", PWD=self.folder.name, TMPDIR=self.folder.name)
        # in a session of its own, so that the signal goes to that process alone
        return subprocess.Popen([*command, "-p", str(port)], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                universal_newlines=True, env=environment, cwd=self.folder.name, start_new_session=True)

    def launch(self, *arguments, file=None):
        return self.start("roslaunch", str(file or self.launch_file), *arguments)

    def end_of(self, process):
        """Exit code and output; the test fails if it does not end."""
        try:
            output, _ = process.communicate(timeout=TIMEOUT)
        except subprocess.TimeoutExpired:
            process.send_signal(signal.SIGINT)
            output, _ = process.communicate()
            self.fail(f"{process.args}: does not end:\n{output}")
        return process.returncode, output

    def output_of(self, *arguments, **more):
        return self.end_of(self.launch(*arguments, **more))

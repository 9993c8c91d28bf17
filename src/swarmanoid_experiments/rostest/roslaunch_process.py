"""What tests of roslaunch itself share: a launch file, with a master on a port of its own."""

import os
import pathlib
import signal
import socket
import subprocess
import tempfile
import unittest

LAUNCH_FOLDER = pathlib.Path(__file__).resolve().parents[3] / "launch"
TIMEOUT = 30.0  # [s]


def free_port():
    with socket.socket() as probe:
        probe.bind(("localhost", 0))
        return probe.getsockname()[1]


class RoslaunchTest(unittest.TestCase):
    """Each test has a folder of its own, in which roslaunch is started."""

    launch_file = None

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def launch(self, *arguments):
        port = free_port()
        environment = dict(os.environ, ROS_HOME=self.folder.name, ROS_MASTER_URI=f"http://localhost:{port}",
                           ROS_HOSTNAME="localhost", PWD=self.folder.name)
        command = ["roslaunch", "-p", str(port), str(self.launch_file), *arguments]
        # in a session of its own, so that the signal goes to roslaunch alone
        return subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, universal_newlines=True,
                                env=environment, cwd=self.folder.name, start_new_session=True)

    def output_of(self, *arguments):
        """Exit code and output; the test fails if it does not end."""
        process = self.launch(*arguments)
        try:
            output, _ = process.communicate(timeout=TIMEOUT)
        except subprocess.TimeoutExpired:
            process.send_signal(signal.SIGINT)
            output, _ = process.communicate()
            self.fail(f"{arguments}: does not end:\n{output}")
        return process.returncode, output

"""Shared by the tests over two hosts: a master and the test itself on host a, and launch files on both."""

import os
import pathlib
import signal
import subprocess
import tempfile
import time
import unittest

import rosgraph
import rospy

from space_client import TIMEOUT
from two_hosts import TwoHosts, why_not

LAUNCH_FILES = pathlib.Path(__file__).resolve().parents[3] / "launch"
DELAY = 0.005  # [s] each way


class TwoHostsCase(unittest.TestCase):
    """Only one of these classes per process, because a node starts only once."""

    @classmethod
    def setUpClass(cls):
        reason = why_not()
        if reason:
            raise unittest.SkipTest(reason)
        cls.hosts = TwoHosts(DELAY)
        cls.addClassCleanup(cls.hosts.close)
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        os.environ.update(cls.hosts.a.environment(cls.hosts.a), ROS_HOME=folder.name)
        os.environ.pop("ROS_HOSTNAME", None)
        cls.hosts.a.enter()
        master = subprocess.Popen(["rosmaster", "--core"], stdout=subprocess.DEVNULL)
        cls.addClassCleanup(cls.end, master)
        until = time.monotonic() + TIMEOUT
        while not rosgraph.is_master_online() and time.monotonic() < until:
            time.sleep(0.1)
        rospy.init_node("two_hosts_test", disable_signals=True)
        cls.addClassCleanup(rospy.signal_shutdown, "the tests are over")

    @staticmethod
    def end(process):
        process.send_signal(signal.SIGINT)
        process.wait(TIMEOUT)

    def launch(self, host, file, **arguments):
        command = ["roslaunch", LAUNCH_FILES / file, f"hostname:={host.address}"]
        process = subprocess.Popen(host.command(*command, *(f"{name}:={value}" for name, value in arguments.items())),
                                   env=host.environment(self.hosts.a), start_new_session=True)
        self.addCleanup(self.end, process)

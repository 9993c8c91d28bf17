"""A launched experiment with its own master: start, services, and end."""

import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time

import rosgraph
import rospy
from std_srvs.srv import Trigger
from swarmanoid_msgs.srv import Reset, Step

from table import ROOT

sys.path.append(str(ROOT / "src/swarmanoid_experiments/rostest"))
from roslaunch_process import free_port  # noqa: E402  pylint: disable=wrong-import-position

TIMEOUT = 60.0  # [s]


class Launched:
    """A launched space: paused before the first tick, and by default as fast as possible afterwards."""

    def __init__(self, *arguments, environment=None):
        self.folder = tempfile.TemporaryDirectory()
        self.path = pathlib.Path(self.folder.name)
        port = free_port()
        os.environ.update(ROS_MASTER_URI=f"http://localhost:{port}", ROS_HOSTNAME="localhost")
        settings = {"rviz": "false", "paused": "true", "real_time_factor": "0", "on_end": "stay", "out": self.path}
        settings.update(argument.split(":=", 1) for argument in arguments)
        command = ["roslaunch", "-p", str(port), ROOT / "launch/run.launch"]
        self.log = open(self.path / "log.txt", "w+")
        self.process = subprocess.Popen(
            command + [f"{name}:={value}" for name, value in settings.items()], stdout=self.log,
            stderr=subprocess.STDOUT, start_new_session=True,
            env=dict(os.environ, ROS_HOME=str(self.path / "ros"), **(environment or {})))
        try:
            for name, kind in (("reset", Reset), ("step", Step), ("resume", Trigger)):
                self.wait_for_service("/space/" + name)
                setattr(self, name, rospy.ServiceProxy("/space/" + name, kind, persistent=True))
        except Exception:
            self.stop()
            raise

    def wait_for_service(self, name):
        until = time.monotonic() + TIMEOUT
        while not rosgraph.is_master_online() or not self.is_offered(name):
            if time.monotonic() > until or self.process.poll() is not None:
                self.log.seek(0)
                raise RuntimeError(f"{name} is not there: {self.log.read()}")
            time.sleep(0.05)

    @staticmethod
    def is_offered(name):
        return name in [service for service, _ in rosgraph.Master("/figures").getSystemState()[2]]

    @staticmethod
    def subscribers():
        """Subscribers by topic, without the nodes of a launch without rviz, which read logs and the clock."""
        own = {"/swarmanoid", "/space", "/rosout"}
        everybody = {topic: set(nodes) - own for topic, nodes in rosgraph.Master("/figures").getSystemState()[1]}
        return {topic: nodes for topic, nodes in everybody.items() if nodes}

    def run_to_end(self):
        """@return ticks, and wall time measured by the caller of the service [s]"""
        start = time.monotonic()
        answer = self.step(10**6)
        seconds = time.monotonic() - start
        if answer.message != "the run finished before all of them were made":
            raise RuntimeError(answer.message)
        return answer.tick, seconds

    def stop(self):
        """Ends the launch by SIGINT, like Ctrl-C."""
        if self.process.poll() is None:
            self.process.send_signal(signal.SIGINT)
            self.process.wait(TIMEOUT)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.stop()
        self.log.close()
        self.folder.cleanup()

"""Controllers in their own processes, started and ended by tests."""

import os
import signal
import subprocess

import rospy
from diagnostic_msgs.msg import DiagnosticArray
from swarmanoid_msgs.srv import SetCommandSource

from space_client import TIMEOUT, Collector

CONTROLLERS = {"fb_1": "footbot_retrieval", "fb_2": "footbot_retrieval", "fb_3": "footbot_retrieval",
               "eb": "eyebot_retrieval"}


class Participant:
    """The content of launch/robot.launch: a standalone nodelet."""

    def __init__(self, robot, controller=None, **parameters):
        self.name = robot + "_controller"
        nodelet = "swarmanoid_controllers/" + (controller or CONTROLLERS[robot])
        parameters = dict(parameters, robots=robot, space="/space")
        arguments = [f"_{name}:={value}" for name, value in parameters.items()]
        self._process = subprocess.Popen(["rosrun", "nodelet", "nodelet", "standalone", nodelet,
                                          "__name:=" + self.name] + arguments, start_new_session=True)

    def kill(self):
        """Like kill -9."""
        self._end(signal.SIGKILL)

    def end(self):
        if self._process.poll() is None:
            self._end(signal.SIGINT)

    def wait(self):
        """@return exit code"""
        return self._process.wait(TIMEOUT)

    def _end(self, how):
        os.killpg(self._process.pid, how)
        self.wait()


def set_source(names, source):
    rospy.wait_for_service("/space/set_command_source", TIMEOUT)
    return rospy.ServiceProxy("/space/set_command_source", SetCommandSource)(names=names, source=source)


class LockstepStatus:
    """The space's status in /diagnostics."""

    def __init__(self):
        self._diagnostics = Collector("/diagnostics", DiagnosticArray)

    def wait_for(self, text):
        """@return whether a status contains the text from now on"""
        self._diagnostics.clear()
        return self._diagnostics.wait_for(lambda array: any(
            text in status.message for status in array.status if status.name.endswith("lockstep"))) is not None

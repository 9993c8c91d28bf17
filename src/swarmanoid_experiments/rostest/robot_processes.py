"""A robot in two processes, a simulated robot and its controller's host, started and ended by a test."""

import os
import signal
import subprocess
import threading
import time
import unittest
import xmlrpc.client

import rosgraph
import rospy

TIMEOUT = 20.0  # [s]
RATE = 20.0  # [Hz] of the controllers

SMALL = {"footbot": {"sensors": ["footbot_proximity"],
                     "actuators": ["footbot_wheels", "footbot_gripper", "footbot_turret"]},
         "eyebot": {"sensors": ["eyebot_camera", "eyebot_magnet_state"], "actuators": ["eyebot_velocity", "eyebot_laser"],
                    "safe_stop": {"hover": 0.5, "descend_speed": 0.4, "descend_time": 1.0}},
         "handbot": {"sensors": ["handbot_rope_state"], "actuators": ["handbot_arms", "handbot_hands", "handbot_rope"]}}


class Process:
    """A program in a session of its own."""

    def __init__(self, command):
        self._process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                                         env=dict(os.environ, ROSCONSOLE_STDOUT_LINE_BUFFERED="1"),
                                         start_new_session=True)
        self._lines = []
        self._reader = threading.Thread(target=self._read, daemon=True)
        self._reader.start()

    def _read(self):
        for line in self._process.stdout:
            self._lines.append(line)

    def send(self, how):
        os.kill(self._process.pid, how)

    def wait(self, timeout=TIMEOUT):
        """@return its exit code"""
        code = self._process.wait(timeout)
        self._reader.join(TIMEOUT)
        return code

    def output(self):
        return "".join(self._lines)

    def wait_for_text(self, text):
        return wait_until(lambda: text in self.output())

    def end(self):
        if self._process.poll() is None:
            self.send(signal.SIGCONT)
            self.send(signal.SIGKILL)
            self._process.wait(TIMEOUT)


class Drivers(Process):
    """The nodes that launch/mock_robot.launch starts."""

    def __init__(self, robot, kind, **arguments):
        self._node = f"/{robot}_drivers"
        self._pid = None
        super().__init__(["roslaunch", "swarmanoid_experiments", "mock_robot.launch", f"robot:={robot}", f"type:={kind}",
                          *(f"{name}:={value}" for name, value in arguments.items())])

    def send_to_node(self, how):
        """Sends a signal to the process of the nodes, not to roslaunch."""
        if self._pid is None:  # a stopped process could not answer
            address = rosgraph.Master("/robot_processes").lookupNode(self._node)
            self._pid = xmlrpc.client.ServerProxy(address).getPid("/robot_processes")[2]
        os.kill(self._pid, how)

    def end(self):
        if self._process.poll() is None:
            self.send(signal.SIGINT)
            self.wait()


class Host(Process):
    """The nodes that launch/robot.launch starts with provider:=topics."""

    def __init__(self, robot, configuration, **parameters):
        self.name = robot + "_controller"
        own = {"provider": "topics", "robots": robot, "configuration": configuration, "controller": "misbehaving",
               "library": "misbehaving_host_controller"}
        rospy.set_param("/" + self.name, dict(own, **parameters))
        super().__init__(["rosrun", "nodelet", "nodelet", "standalone", "swarmanoid_hosts/ControllerNodelet",
                          "__name:=" + self.name])


def configuration(kind, **changes):
    return dict({"robot_type": kind, "rate": RATE, "sensor_timeout": 0.5, "start_timeout": TIMEOUT}, **dict(SMALL[kind], **changes))


class RobotTestCase(unittest.TestCase):
    """Ends the processes of a test, the last one first."""

    def setUp(self):
        self.processes = []

    def tearDown(self):
        self.end()

    def end(self):
        """Ends the present robot: all simulated ones have a node of the same name, /space."""
        while self.processes:
            self.processes.pop().end()


class Arrivals:
    """All messages of a topic, each with its time of arrival."""

    def __init__(self, topic, kind):
        self._lock = threading.Lock()
        self._messages = []
        self._subscriber = rospy.Subscriber(topic, kind, self._take, queue_size=1000, tcp_nodelay=True)

    def _take(self, message):
        with self._lock:
            self._messages.append((time.monotonic(), message))

    def all(self):
        with self._lock:
            return list(self._messages)

    def messages(self):
        return [message for _, message in self.all()]

    def wait_for(self, is_it, timeout=TIMEOUT):
        """Returns the first message that fulfils the condition, after its time of arrival; None if there is none."""
        found = []

        def look():
            found[:] = [item for item in self.all() if is_it(item[1])][:1]
            return found

        wait_until(look, timeout)
        return found[0] if found else None


def wait_until(is_so, timeout=TIMEOUT):
    end = time.monotonic() + timeout
    while time.monotonic() < end:
        if is_so():
            return True
        time.sleep(0.01)
    return False

"""Shared by the tests of a launched space."""

import subprocess
import tempfile
import threading
import time

import rospy
from nodelet.srv import NodeletLoad, NodeletLoadRequest, NodeletUnload, NodeletUnloadRequest
from std_srvs.srv import Trigger
from swarmanoid_msgs.srv import (Delete, Handover, Inspect, Move, PaintFloor, Reset, ResetRequest, SetFault, SetProperty, SetRealTimeFactor,
                                 Spawn, Step)

TIMEOUT = 15.0  # [s] of wall time


class Space:
    """The services of the space node."""

    def __init__(self):
        services = {"pause": Trigger, "resume": Trigger, "toggle_pause": Trigger, "step": Step, "reset": Reset,
                    "spawn": Spawn, "delete": Delete, "move": Move, "handover": Handover,
                    "set_property": SetProperty, "paint_floor": PaintFloor, "set_fault": SetFault,
                    "set_real_time_factor": SetRealTimeFactor, "inspect": Inspect}
        for name, service in services.items():
            rospy.wait_for_service("/space/" + name, TIMEOUT)
            setattr(self, name, rospy.ServiceProxy("/space/" + name, service))

    def restart(self, **request):
        """Pauses and resets to before the first tick."""
        self.pause()
        return self.reset(ResetRequest(**request))


def unload(name):
    rospy.wait_for_service("/swarmanoid/unload_nodelet", TIMEOUT)
    return rospy.ServiceProxy("/swarmanoid/unload_nodelet", NodeletUnload)(NodeletUnloadRequest(name=name)).success


def load(name, kind):
    rospy.wait_for_service("/swarmanoid/load_nodelet", TIMEOUT)
    proxy = rospy.ServiceProxy("/swarmanoid/load_nodelet", NodeletLoad)
    try:
        return proxy(NodeletLoadRequest(name=name, type=kind)).success
    except rospy.ServiceException:
        return False


def run_without_ros(test, experiment, seed):
    """Returns the state hash of every tick, as lines."""
    with tempfile.NamedTemporaryFile("r") as hashes:
        command = ["swarmanoid", "run", experiment, "--seed", str(seed), "--quiet", "--force", "--hashes",
                   hashes.name]
        done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, universal_newlines=True)
        test.assertEqual(0, done.returncode, done.stderr)
        return hashes.read().splitlines()


class Collector:
    """Keeps all messages of a topic; waits in wall time, because ROS time may stand still."""

    def __init__(self, topic, kind):
        self._changed = threading.Condition()
        self._messages = []
        self._subscriber = rospy.Subscriber(topic, kind, self._take, queue_size=10000)

    def _take(self, message):
        with self._changed:
            self._messages.append(message)
            self._changed.notify_all()

    def wait_for_publisher(self, count=1):
        """Waits until `count` publishers are connected, so that no later message is lost."""
        until = time.monotonic() + TIMEOUT
        while self._subscriber.get_num_connections() < count and time.monotonic() < until:
            time.sleep(0.01)
        time.sleep(0.1)  # for the publisher's side of the connection

    def messages(self):
        with self._changed:
            return list(self._messages)

    def clear(self):
        with self._changed:
            self._messages = []

    def wait_for(self, is_it, timeout=TIMEOUT):
        """Returns the first message for which `is_it` is true; None if there is none in time."""
        found = []

        def look():
            found[:] = [message for message in self._messages if is_it(message)]
            return bool(found)

        with self._changed:
            self._changed.wait_for(look, timeout)
        return found[0] if found else None

"""The conformance test with controllers that command their robots over standard topics, from any provider."""

import rospy
from diagnostic_msgs.msg import DiagnosticArray

from participants import Participant
from space_client import Collector

DEVICES = {"footbot": (["footbot_proximity", "footbot_camera", "footbot_gripper_state", "footbot_turret_state",
                        "range_and_bearing_received", "wifi_received", "bluetooth_received", "rfid_reader"],
                       ["footbot_wheels", "footbot_gripper", "footbot_turret", "footbot_leds", "range_and_bearing", "wifi",
                        "bluetooth", "rfid_writer"]),
           "eyebot": (["eyebot_camera", "eyebot_magnet_state", "eyebot_distance", "range_and_bearing_received"],
                      ["eyebot_velocity", "eyebot_laser", "eyebot_leds", "eyebot_magnet", "range_and_bearing"]),
           "handbot": (["handbot_arms_state", "handbot_hands_state", "handbot_rope_state", "handbot_camera",
                        "handbot_distance", "handbot_proximity", "handbot_vacuum", "range_and_bearing_received"],
                       ["handbot_arms", "handbot_hands", "handbot_rope", "range_and_bearing"])}
SETTLING = 1.0  # [s]: both ways over topics, on a busy machine
TOLERANCE = 0.3  # robot and host have separate clocks: 2 s of motion may vary by up to two periods of 0.1 s
LONGEST = 110.0  # [s] of wall time for all checks of a robot


class ConformanceHosts:
    """A host for each robot. @param robots: types and further parameters of the test, by name"""

    def __init__(self, robots):
        self._diagnostics = Collector("/diagnostics", DiagnosticArray)
        self._hosts = []
        for robot, (kind, parameters) in robots.items():
            sensors, actuators = DEVICES[kind]
            rospy.set_param(f"/{robot}_controller/configuration",
                            {"robot_type": kind, "sensors": sensors, "actuators": actuators, "start_timeout": 60,
                             "sensor_timeout": 2.0, "parameters": dict(parameters, settling_time=SETTLING,
                                                   tolerance=TOLERANCE)})
            self._hosts.append(Participant(robot, controller="conformance", provider="topics"))

    def verdict(self, robot):
        """@return the final results of this robot's test: conformance, passed, unchecked, unchecked_devices"""
        seen = {}

        def is_over(array):
            for status in array.status:
                if status.name == f"{robot}: controller":
                    seen.update({pair.key[len("controller: "):]: pair.value for pair in status.values
                                 if pair.key.startswith("controller: ")})
                    seen["state"] = status.message
            return seen.get("conformance", "running") != "running" or "failed" in seen.get("state", "")

        self._diagnostics.wait_for(is_over, LONGEST)
        return seen

    def end(self):
        for host in self._hosts:
            host.end()

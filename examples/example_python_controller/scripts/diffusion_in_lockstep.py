#!/usr/bin/python3
"""diffusion_in_lockstep.py ROBOT...: straight on until something is near ahead, then turn away from it, on and on until
nothing is.

The space waits in each tick for this process, so the run is the one that the C++ controller of the same name makes, to
the last bit."""

import math
import sys

import rospy
from swarmanoid_python import Participant

WHEEL_RADIUS = 0.029      # [m]
WHEEL_SEPARATION = 0.140  # [m]
TURN_RATE = 1.5           # [rad/s]
HALF_FIELD = 1.5          # [rad]; objects farther to the side do not count
SENSORS = 24
STEP = 6.283185307179586 / SENSORS
ANGLES = [(i if i <= SENSORS // 2 else i - SENSORS) * STEP for i in range(SENSORS)]


class Diffusion:
    def __init__(self, robot):
        self._proximity = robot.sensors.footbot_proximity
        self._wheels = robot.actuators.footbot_wheels
        self._speed = float(robot.parameters.get("speed", 0.1))  # [m/s]
        self._threshold = float(robot.parameters.get("threshold", 0.05))
        self._turn_rate = 0.0  # [rad/s], while it turns away

    def step(self, _time, _dt):
        x = y = 0.0
        for value, angle in zip(self._proximity.value, ANGLES):
            if value > 0.0 and abs(angle) <= HALF_FIELD:
                x += value * math.cos(angle)
                y += value * math.sin(angle)
        if math.hypot(x, y) <= self._threshold:
            self._turn_rate = 0.0
            self._drive(self._speed, 0.0)
            return
        if self._turn_rate == 0.0:
            self._turn_rate = -TURN_RATE if y > 0.0 else TURN_RATE
        self._drive(0.0, self._turn_rate)

    def _drive(self, speed, turn_rate):
        difference = 0.5 * turn_rate * WHEEL_SEPARATION
        self._wheels.left = (speed - difference) / WHEEL_RADIUS
        self._wheels.right = (speed + difference) / WHEEL_RADIUS


if __name__ == "__main__":
    rospy.init_node("diffusion_in_lockstep", anonymous=True)
    Participant(rospy.myargv()[1:], Diffusion).run()

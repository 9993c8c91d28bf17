#!/usr/bin/python3
"""diffusion_free_running.py ROBOT: drives straight on until an obstacle is near, then turns away from it, over the robot's
standard topics. It drives simulated and real robots; the simulator does not wait for it, so no two runs are equal."""

import math

import rospy
from geometry_msgs.msg import Twist
from swarmanoid_msgs.msg import ProximityArray

RATE = 10.0      # [commands/s]; a robot stops after 0.5 s without a command
SPEED = 0.1      # [m/s]
TURN_RATE = 1.5  # [rad/s]
THRESHOLD = 0.05
HALF_FIELD = 1.5  # [rad]; obstacles farther to the side are ignored


class Diffusion:
    def __init__(self, robot):
        self._command = Twist()
        self._publisher = rospy.Publisher(f"/{robot}/cmd_vel", Twist, queue_size=1)
        rospy.Subscriber(f"/{robot}/proximity", ProximityArray, self._look, queue_size=1, tcp_nodelay=True)

    def _look(self, readings):
        ahead = [(value, angle) for value, angle in zip(readings.values, readings.angles) if abs(angle) <= HALF_FIELD]
        x = sum(value * math.cos(angle) for value, angle in ahead)
        y = sum(value * math.sin(angle) for value, angle in ahead)
        command = Twist()
        if math.hypot(x, y) <= THRESHOLD:
            command.linear.x = SPEED
        else:  # a turn keeps its side until it ends
            command.angular.z = self._command.angular.z or (-TURN_RATE if y > 0.0 else TURN_RATE)
        self._command = command

    def drive(self):
        rate = rospy.Rate(RATE)
        while not rospy.is_shutdown():
            self._publisher.publish(self._command)
            rate.sleep()


if __name__ == "__main__":
    rospy.init_node("diffusion_free_running", anonymous=True)
    try:
        Diffusion(rospy.myargv()[1]).drive()
    except rospy.ROSInterruptException:
        pass  # ROS was shut down during sleep

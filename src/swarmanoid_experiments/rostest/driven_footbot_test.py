#!/usr/bin/python3
"""A footbot driven by a publisher: its odometry, inertial sensors, ground sensors and scanner agree with the world, known
only from tf and the experiment file."""

import math
import sys
import time
import unittest

import rospy
import rostest
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from sensor_msgs.msg import Imu, LaserScan
from swarmanoid_msgs.msg import GroundArray, ScannerCommand
from tf2_msgs.msg import TFMessage

from space_client import TIMEOUT, Collector, Space

TICK = 0.1  # [s]
SPEED = 0.1  # [m/s]
TURN_RATE = -0.35  # [rad/s]
TICKS = 23
PATIENCE = 50  # ticks until a command has an effect
START = (1.6, 1.6)  # [m], heading 0
PATCH = ((1.8, 1.1), (2.4, 2.1))  # [m], corners; black
# its centre [m], heading, half its thickness [m]; its ends are far from the robot
WALL = ((2.045, 1.89), math.radians(147), 0.05)
ROUNDING = 1e-3  # [m]


def publisher(topic, kind):
    result = rospy.Publisher(topic, kind, queue_size=1)
    until = time.monotonic() + TIMEOUT
    while result.get_num_connections() == 0 and time.monotonic() < until:
        time.sleep(0.01)
    return result


def twist(speed, turn_rate):
    result = Twist()
    result.linear.x = speed
    result.angular.z = turn_rate
    return result


def heading_of(rotation):
    return 2.0 * math.atan2(rotation.z, rotation.w)


def way_to_wall(place, direction):
    """[m] along a ray; infinite if it leads away from the wall. The robot is to the left of the wall's heading."""
    middle, heading, thickness = WALL
    normal = (-math.sin(heading), math.cos(heading))
    gap = sum((p - m) * n for p, m, n in zip(place, middle, normal)) - thickness
    nearer = -(math.cos(direction) * normal[0] + math.sin(direction) * normal[1])
    return gap / nearer if nearer > 1e-9 else math.inf


class DrivenFootbotTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.space = Space()
        kinds = {"odom": Odometry, "ground_truth/odom": Odometry, "imu/data": Imu, "ground": GroundArray, "scan": LaserScan}
        cls.readings = {topic: Collector("/fb/" + topic, kind) for topic, kind in kinds.items()}
        cls.transforms = Collector("/tf", TFMessage)
        for collector in [*cls.readings.values(), cls.transforms]:
            collector.wait_for_publisher()
        cls.velocity = publisher("/fb/cmd_vel", Twist)
        cls.scanner = publisher("/fb/scanner/command", ScannerCommand)

    def setUp(self):
        """Drives an arc, then stands still until all sensors read the place where the arc ended."""
        self.space.restart()
        for collector in [*self.readings.values(), self.transforms]:
            collector.clear()
        self.drive(SPEED, TURN_RATE)
        self.space.step(TICKS - 1)
        self.driving = self.latest("imu/data")  # in one more tick
        self.ticks = TICKS + 1 + self.drive(0.0, 0.0)
        self.place, self.heading = self.pose(self.space.step(4).stamp)

    def latest(self, topic):
        """Returns the reading of one more tick, which is of the state before it."""
        stamp = self.space.step(1).stamp - rospy.Duration.from_sec(TICK)
        reading = self.readings[topic].wait_for(lambda message: message.header.stamp == stamp)
        self.assertIsNotNone(reading, f"{topic} of {stamp.to_sec()} s")
        return reading

    def latest_after(self, publish, topic, is_obeyed):
        """Commands, and steps single ticks until a reading shows the effect of the command.
        @return that reading, the number of ticks before it"""
        publish()
        for ticks in range(PATIENCE):
            time.sleep(0.1)  # a command takes effect at the tick after its arrival
            reading = self.latest(topic)
            if is_obeyed(reading):
                return reading, ticks
        self.fail(f"a command has had no effect on {topic} in {PATIENCE} ticks")

    def drive(self, speed, turn_rate):
        """Commands speeds for one tick. @return the number of ticks before it, with the previous speeds"""
        def is_obeyed(message):
            wheels = message.twist.twist
            return math.hypot(wheels.linear.x - speed, wheels.angular.z - turn_rate) < 1e-6
        return self.latest_after(lambda: self.velocity.publish(twist(speed, turn_rate)), "odom", is_obeyed)[1]

    def pose(self, stamp):
        """Returns place and heading from tf."""
        def of_robot(message):
            return [t for t in message.transforms if t.child_frame_id == "fb/base_link" and t.header.stamp == stamp]
        message = self.transforms.wait_for(of_robot)
        self.assertIsNotNone(message, f"tf of {stamp.to_sec()} s")
        found, = of_robot(message)
        self.assertEqual("world", found.header.frame_id)
        place = found.transform.translation
        return (place.x, place.y), heading_of(found.transform.rotation)

    def test_odometry_is_the_way_by_the_transforms(self):
        message = self.latest("odom")
        self.assertEqual(("fb/odom", "fb/base_link"), (message.header.frame_id, message.child_frame_id))
        odom = message.pose.pose
        self.assertAlmostEqual(self.place[0] - START[0], odom.position.x, 6)
        self.assertAlmostEqual(self.place[1] - START[1], odom.position.y, 6)
        self.assertAlmostEqual(self.heading, heading_of(odom.orientation), 6)
        angle = TURN_RATE * self.ticks * TICK  # of the commanded arc
        self.assertAlmostEqual(angle, self.heading, 6)
        self.assertAlmostEqual(START[0] + SPEED / TURN_RATE * math.sin(angle), self.place[0], 6)
        self.assertAlmostEqual(START[1] + SPEED / TURN_RATE * (1.0 - math.cos(angle)), self.place[1], 6)

    def test_ground_truth_is_the_pose_by_the_transforms_and_the_velocity_ahead(self):
        self.drive(SPEED, TURN_RATE)
        stamp = self.space.step(3).stamp
        place, heading = self.pose(stamp)
        self.assertGreater(abs(heading), 0.5, "ahead of the robot is not along the axes of the world")
        truth = self.readings["ground_truth/odom"].wait_for(lambda message: message.header.stamp == stamp)
        self.assertEqual(("world", "fb/base_link"), (truth.header.frame_id, truth.child_frame_id))
        self.assertAlmostEqual(place[0], truth.pose.pose.position.x, 9)
        self.assertAlmostEqual(place[1], truth.pose.pose.position.y, 9)
        self.assertAlmostEqual(heading, heading_of(truth.pose.pose.orientation), 9)
        self.assertAlmostEqual(SPEED, truth.twist.twist.linear.x, 6)
        self.assertAlmostEqual(0.0, truth.twist.twist.linear.y, 6)
        self.assertAlmostEqual(TURN_RATE, truth.twist.twist.angular.z, 6)

    def test_a_reading_has_the_stamp_of_the_state_that_was_sensed(self):
        self.drive(SPEED, TURN_RATE)
        for _ in range(3):
            message = self.latest("odom")
            place, heading = self.pose(message.header.stamp)
            self.assertGreater(math.dist(place, self.place), 0.5 * SPEED * TICK, "it has moved on")
            self.place = place
            odom = message.pose.pose
            self.assertAlmostEqual(place[0] - START[0], odom.position.x, 6)
            self.assertAlmostEqual(place[1] - START[1], odom.position.y, 6)
            self.assertAlmostEqual(heading, heading_of(odom.orientation), 6)

    def test_inertial_sensors_feel_the_turn(self):
        self.assertEqual("fb/base_link", self.driving.header.frame_id)
        self.assertAlmostEqual(TURN_RATE, self.driving.angular_velocity.z, 6)
        acceleration = self.driving.linear_acceleration
        self.assertAlmostEqual(abs(TURN_RATE) * SPEED, math.hypot(acceleration.x, acceleration.y), 6)
        self.assertLess(acceleration.y, 0.0, "to the right, where the centre is")
        self.assertAlmostEqual(9.81, acceleration.z, 6)
        self.assertEqual(0.0, self.latest("imu/data").angular_velocity.z, "it stands")

    def test_ground_sensors_read_the_patch(self):
        message = self.latest("ground")
        self.assertEqual(8, len(message.values))
        expected = []
        for i in range(8):
            direction = self.heading + math.radians(22.5 + 45.0 * i)
            spot = [p + 0.063 * way for p, way in zip(self.place, (math.cos(direction), math.sin(direction)))]
            is_black = all(low < value < high for value, low, high in zip(spot, *PATCH))
            expected.append(0.0 if is_black else 1.0)
        self.assertEqual({0.0, 1.0}, set(expected), "it stands on the edge")
        self.assertEqual(expected, list(message.values))

    def test_the_scan_is_the_wall(self):
        turn = ScannerCommand(mode=ScannerCommand.SPEED, speed=5.0)
        scan, _ = self.latest_after(lambda: self.scanner.publish(turn), "scan",
                                    lambda message: not all(map(math.isnan, message.ranges)))
        hits = 0
        for _ in range(13):  # more than a revolution
            self.assertEqual("fb/scanner", scan.header.frame_id)
            for i, distance in enumerate(scan.ranges):
                if math.isnan(distance):
                    continue
                direction = self.heading + scan.angle_min + i * scan.angle_increment
                # a sample is stored at the nearest of the scan's angles
                edges = [way_to_wall(self.place, direction + side * 0.5 * scan.angle_increment) for side in (-1, 1)]
                if math.isfinite(distance):
                    hits += 1
                    self.assertLessEqual(min(edges) - ROUNDING, distance)
                    self.assertGreaterEqual(max(edges) + ROUNDING, distance)
                elif distance > 0.0:
                    self.assertGreaterEqual(max(edges), 1.5, "nothing within the range of the long beams")
            scan = self.latest("scan")
        self.assertGreater(hits, 20)
        self.scanner.publish(ScannerCommand(mode=ScannerCommand.OFF))


if __name__ == "__main__":
    rospy.init_node("driven_footbot_test")
    rostest.rosrun("swarmanoid_experiments", "driven_footbot", DrivenFootbotTest, sys.argv)

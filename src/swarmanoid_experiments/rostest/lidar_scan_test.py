#!/usr/bin/python3
"""The lidar of a robot from outside the suite, the TurtleBot3 of the templates, as subscribers receive it."""

import math
import os
import pathlib
import shutil
import signal
import unittest

import rospy
from sensor_msgs.msg import LaserScan

from roslaunch_process import LAUNCH_FOLDER, RoslaunchTest
from space_client import Collector, Space

EXAMPLE = LAUNCH_FOLDER.parent / "examples/example_turtlebot3"
X, Y, HEADING = 1.3, 2.1, 0.37   # of the robot [m, m, rad]
MOUNT = -0.032                   # of the lidar, along the robot's axis [m]
WALL = 3.4                       # y coordinate of the face of the only wall [m]
REACH = 3.5                      # [m]
WORLD = f"""<ahss-config>
  <framework><clocktick>100</clocktick><maxclock>100</maxclock></framework>
  <controllers>
    <diffusion id="c" library="diffusion">
      <actuators><differential_drive/></actuators><sensors><lidar><rate>5</rate></lidar></sensors><parameters/>
    </diffusion>
  </controllers>
  <arena size="8,8,1" optimization="2D">
    <turtlebot3_burger id="burger">
      <position>{X}, {Y}, 0</position><orientation>0, 0, {math.degrees(HEADING)!r}</orientation>
      <controller source="none">c</controller>
    </turtlebot3_burger>
    <block id="wall"><position>{WALL + 0.1}, 4, 0.5</position><orientation>0, 0, 0</orientation><size>0.2, 8, 1</size></block>
  </arena>
  <engines><kinematics2d id="ground"/></engines>
  <arena_physics><engine id="ground"><entity id="burger"/><entity id="wall"/></engine></arena_physics>
</ahss-config>
"""


def free_way(bearing):
    """Returns the distance from the lidar to the wall, in this direction of the world [m]."""
    if math.cos(bearing) <= 0:
        return math.inf
    way = (WALL - X - MOUNT * math.cos(HEADING)) / math.cos(bearing)
    y = Y + MOUNT * math.sin(HEADING) + way * math.sin(bearing)
    return way if way <= REACH and 0 <= y <= 8 else math.inf


class LidarScanTest(RoslaunchTest):
    launch_file = LAUNCH_FOLDER / "run.launch"

    def setUp(self):
        super().setUp()
        here = pathlib.Path(self.folder.name)
        shutil.copytree(EXAMPLE, here / "installed/share/example_turtlebot3")
        before = os.environ["CMAKE_PREFIX_PATH"]
        self.addCleanup(os.environ.__setitem__, "CMAKE_PREFIX_PATH", before)
        os.environ["CMAKE_PREFIX_PATH"] = f"{here / 'installed'}:{before}"
        (here / "world.xml").write_text(WORLD)

    def test_scans_are_those_of_the_page(self):
        process = self.launch("rviz:=false", "experiment:=world.xml", "device_topics:=burger", "paused:=true", "real_time_factor:=0")
        self.addCleanup(self.end_of, process)
        self.addCleanup(process.send_signal, signal.SIGINT)
        os.environ.update(ROS_MASTER_URI=self.master, ROS_HOSTNAME="localhost")
        rospy.init_node("lidar_scan_test")
        scans = Collector("/burger/scan", LaserScan)
        space = Space()
        scans.wait_for_publisher()
        space.step(6)
        # five scans per second, with ten ticks per second
        self.assertIsNotNone(scans.wait_for(lambda scan: scan.header.stamp.to_nsec() == 1_400_000_000))
        self.assertEqual([scan.header.stamp.to_nsec() // 1_000_000 for scan in scans.messages()], [1000, 1200, 1400])
        for scan in scans.messages():
            self.check(scan)

    def check(self, scan):
        self.assertEqual((scan.header.frame_id, len(scan.ranges), len(scan.intensities)), ("burger/lidar", 360, 0))
        self.assertAlmostEqual(scan.angle_min, -math.pi, 6)
        self.assertAlmostEqual(scan.angle_max, math.pi - math.radians(1), 6)
        self.assertAlmostEqual(scan.angle_increment, math.radians(1), 6)
        for value, exact in ((scan.range_min, 0.12), (scan.range_max, REACH), (scan.scan_time, 0.2), (scan.time_increment, 0)):
            self.assertAlmostEqual(value, exact, 6)
        expected = [free_way(HEADING - math.pi + math.radians(i)) for i in range(360)]
        self.assertGreater(sum(map(math.isfinite, expected)), 90)
        for i, (seen, way) in enumerate(zip(scan.ranges, expected)):
            self.assertTrue(seen == way or abs(seen - way) < 1e-4, f"beam {i}: {seen} m, expected {way} m")


if __name__ == "__main__":
    unittest.main()

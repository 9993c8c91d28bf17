#!/usr/bin/python3
"""A lidar on a user's own robot, from its URDF to arrays: Python reads the scans that the experiment specifies."""

import os
import pathlib
import tempfile
import unittest

import numpy

URDF = """<robot name="surveyor">
  <swarmanoid title="Surveyor" summary="Looks around.">
    <wheels left="left_joint" right="right_joint"/>
  </swarmanoid>
  <link name="base_link"/>
  <joint name="body_joint" type="fixed"><parent link="base_link"/><child link="body"/></joint>
  <link name="body">
    <inertial><origin xyz="0 0 0.05"/><mass value="1"/>
      <inertia ixx="0.002" ixy="0" ixz="0" iyy="0.002" iyz="0" izz="0.003"/></inertial>
    <collision><origin xyz="0 0 0.05"/><geometry><cylinder radius="0.08" length="0.1"/></geometry></collision>
  </link>
  {wheel_left}{wheel_right}
  <joint name="lidar_joint" type="fixed">
    <origin xyz="0.03 0 0.12" rpy="0 0 0.2"/><parent link="base_link"/><child link="lidar"/>
  </joint>
  <link name="lidar"/>
</robot>
"""
WHEEL = """<joint name="{side}_joint" type="continuous"><origin xyz="0 {y} 0.03"/><parent link="base_link"/>
    <child link="{side}"/><axis xyz="0 1 0"/><limit effort="1" velocity="10"/></joint>
  <link name="{side}"><inertial><mass value="0.05"/>
    <inertia ixx="0.00002" ixy="0" ixz="0" iyy="0.00002" iyz="0" izz="0.00002"/></inertial>
    <visual><origin rpy="1.5707963268 0 0"/><geometry><cylinder radius="0.03" length="0.01"/></geometry></visual></link>
"""
PACKAGE = """<package format="2"><name>surveyor</name><version>0.0.0</version><description>A robot.</description>
  <maintainer email="a@example.org">a</maintainer><license>MIT</license>
  <export><swarmanoid robots="${prefix}/urdf"/></export></package>
"""
EXPERIMENT = """<?xml version="1.0"?>
<ahss-config>
  <framework><clocktick>100</clocktick><maxclock>60</maxclock></framework>
  <controllers>
    <diffusion id="c" library="diffusion">
      <actuators><differential_drive/></actuators>
      <sensors><lidar><beams>5</beams><field_of_view>120</field_of_view><rate>2.5</rate><range_max>4</range_max></lidar></sensors>
      <parameters/>
    </diffusion>
  </controllers>
  <arena size="6,6,1" optimization="2D">
    <surveyor id="a">
      <position>1, 2, 0</position><orientation>0, 0, 0</orientation><controller>c</controller>
    </surveyor>
    <surveyor id="b">
      <position>1, 4, 0</position><orientation>0, 0, 0</orientation><controller>c</controller>
    </surveyor>
    <block id="wall"><position>4, 3, 0.5</position><orientation>0, 0, 0</orientation><size>0.2, 12, 1</size></block>
  </arena>
  <engines><kinematics2d id="ground"/></engines>
  <arena_physics><engine id="ground"><entity id="a"/><entity id="b"/><entity id="wall"/></engine></arena_physics>
</ahss-config>
"""


def put_into(folder):
    """Writes the robot's package as if a workspace were installed into that folder."""
    package = pathlib.Path(folder) / "share/surveyor"
    (package / "urdf").mkdir(parents=True)
    (package / "package.xml").write_text(PACKAGE)
    wheels = {f"wheel_{side}": WHEEL.format(side=side, y=y) for side, y in (("left", 0.06), ("right", -0.06))}
    (package / "urdf/surveyor.urdf").write_text(URDF.format(**wheels))


FOLDER = tempfile.TemporaryDirectory(prefix="lidar_test_")
put_into(FOLDER.name)
os.environ["CMAKE_PREFIX_PATH"] = f"{FOLDER.name}:{os.environ['CMAKE_PREFIX_PATH']}"
import swarmanoid  # noqa: E402  the import searches for robots


class LidarTest(unittest.TestCase):
    def test_beams_are_elements_of_all_robots(self):
        ages = []

        def drive(robots):
            lidar = robots.readings["lidar"]
            ages.append(lidar.age[0])
            robots.commands["differential_drive"].speed = 0.1

        simulation = swarmanoid.Simulation(text=EXPERIMENT, controllers={"c": drive})
        simulation.tick(9)
        # simulated time begins at 1 s: the first scan is in the first tick, the others are at 1.2 and 1.6 s
        numpy.testing.assert_allclose(ages, [0, 0.1, 0, 0.1, 0.2, 0.3, 0, 0.1, 0.2], atol=1e-12)
        lidar = simulation.robots.readings["lidar"]
        beams = lidar.beams
        self.assertEqual(list(beams.counts), [5, 5])
        self.assertEqual(list(beams.robot), [0] * 5 + [1] * 5)
        self.assertEqual((beams.range.shape, beams.range.dtype), ((10,), numpy.float32))
        angles = numpy.radians([-60, -30, 0, 30, 60])
        numpy.testing.assert_allclose(beams.angle[:5], angles, atol=1e-6)
        # after six ticks at 0.1 m/s, from 3 cm ahead of the robot's origin to the wall's face; the mount is rotated by 0.2 rad
        exact = (3.9 - 1.06 - 0.03) / numpy.cos(angles + 0.2)
        for robot in (0, 1):
            numpy.testing.assert_allclose(beams.range[beams.robot == robot], numpy.where(exact < 4, exact, numpy.inf), atol=1e-5)
        self.assertEqual(list(numpy.isfinite(beams.range[:5])), [False, True, True, True, False])
        numpy.testing.assert_array_equal(lidar.range_max, [4, 4])
        numpy.testing.assert_allclose(lidar.scan_time, [0.4, 0.4], rtol=1e-6)


if __name__ == "__main__":
    unittest.main(argv=[pathlib.Path(__file__).name, "-v"])

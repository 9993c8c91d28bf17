#include "swarmanoid_interface/devices/positioning.hpp"
#include "swarmanoid_experiment_files/robots/robot_model.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "device_world.hpp"

namespace swarmanoid::test {
namespace {

TEST(PositioningTest, AnyRobotIsWhereItIsAndLiesAsItLies) {
  for (const char* type : {"footbot", "eyebot", "handbot"}) {
    DeviceWorld world;
    const Row robot = world.add(robotModel(type), {3.7, 8.1, 0.6}, 2.3);
    SensorUnderTest<Positioning> sensor(world, robot);
    EXPECT_EQ(Eigen::Vector3d(3.7, 8.1, 0.6), sensor.sense().position) << type;
    EXPECT_NEAR(2.3, sensor.sense().heading, 1e-12) << type;
    EXPECT_NEAR(0.0, sensor.sense().roll, 1e-12) << type;
    // rolled to lift its left side by 0.2, then pitched nose down by 0.4, then turned to the right by 1.9
    world.pose(robot).orientation = Eigen::AngleAxisd(-1.9, Eigen::Vector3d::UnitZ()) *
                                    Eigen::AngleAxisd(0.4, Eigen::Vector3d::UnitY()) *
                                    Eigen::AngleAxisd(0.2, Eigen::Vector3d::UnitX());
    const Positioning& said = sensor.sense();
    EXPECT_NEAR(0.2, said.roll, 1e-12) << type;
    EXPECT_NEAR(0.4, said.pitch, 1e-12) << type;
    EXPECT_NEAR(-1.9, said.heading, 1e-12) << type;
    EXPECT_LT(said.orientation().angularDistance(world.pose(robot).orientation), 1e-7) << type;
  }
}

TEST(PositioningTest, ErrorsOfHeadingWrapAndThoseOfPositionDoNot) {
  DeviceWorld world;
  const Row robot = world.addFootbot(9.0, 5.0, 3.1);
  ErrorModelDescription heading;
  heading.kind = "bias";
  heading.field = "heading";
  heading.parameters.add(Configuration("offset", "0.2", {}));
  ErrorModelDescription position;
  position.kind = "bias";
  position.field = "position[0]";
  position.parameters.add(Configuration("offset", "3", {}));
  SensorUnderTest<Positioning> sensor(world, robot, {}, {heading, position});
  EXPECT_NEAR(3.3 - 2.0 * M_PI, sensor.sense().heading, 1e-12);
  EXPECT_NEAR(12.0, sensor.sense().position.x(), 1e-12);
  EXPECT_NEAR(5.0, sensor.sense().position.y(), 1e-12);
}

}  // namespace
}  // namespace swarmanoid::test

// Generic devices of any robot: compared with the specific devices of footbots, and on robots with other parts.
#include <gtest/gtest.h>

#include <cmath>

#include "device_world.hpp"
#include "swarmanoid_experiment_files/robots/robot_model.hpp"
#include "swarmanoid_interface/devices/differential_drive.hpp"
#include "swarmanoid_interface/devices/footbot_proximity.hpp"
#include "swarmanoid_interface/devices/led_array.hpp"
#include "swarmanoid_interface/devices/proximity.hpp"
#include "swarmanoid_interface/devices/wheels.hpp"

namespace swarmanoid::test {
namespace {

/// A footbot with other wheels: 2 cm in radius, 5 cm apart, at most 6 rad/s.
std::shared_ptr<const EntityModel> smallRobot() {
  auto model = std::make_shared<EntityModel>(*robotModel("footbot"));
  model->type = "small_robot";
  model->wheels->radius = 0.02;
  model->wheels->separation = 0.05;
  model->wheels->max_speed = 6.0;
  return model;
}

TEST(AnyRobotTest, WheelsAreLimitedByTheRobotsOwnMotors) {
  DeviceWorld world;
  const Row robot = world.add(smallRobot(), {1.0, 1.0, 0.0});
  ActuatorUnderTest<Wheels> wheels(world, robot);
  wheels.command.setAngularVelocity(5.0, -7.0);
  EXPECT_EQ(wheels.actuate().left, 5.0);
  EXPECT_EQ(wheels.actuate().right, -6.0);
  EXPECT_TRUE(world.space.wheels[robot].is_driven);
  EXPECT_EQ(world.space.wheels[robot].left, 5.0);
  EXPECT_EQ(world.space.wheels[robot].right, -6.0);
}

TEST(AnyRobotTest, SpeedAndTurnRateTurnTheWheelsThatTheRobotHas) {
  DeviceWorld world;
  const Row robot = world.add(smallRobot(), {1.0, 1.0, 0.0});
  ActuatorUnderTest<DifferentialDrive> drive(world, robot);
  drive.command.drive(0.06, 0.8);
  drive.actuate();
  // v / r = 3 rad/s, omega d / 2 / r = 0.8 * 0.05 / 2 / 0.02 = 1 rad/s
  EXPECT_NEAR(world.space.wheels[robot].left, 2.0, 1e-12);
  EXPECT_NEAR(world.space.wheels[robot].right, 4.0, 1e-12);
  drive.command.drive(0.2, 0.8);  // 9 and 11 rad/s, both wheels at their limit
  const DifferentialDrive& limited = drive.actuate();
  EXPECT_NEAR(limited.speed, 0.12, 1e-12);
  EXPECT_NEAR(limited.turn_rate, 0.0, 1e-12);
  EXPECT_NEAR(world.space.wheels[robot].left, 6.0, 1e-12);
  EXPECT_TRUE(drive.stop());
  EXPECT_EQ(world.space.wheels[robot].right, 0.0);
}

TEST(AnyRobotTest, ProximityReadsWhatTheFootbotsOwnRingReads) {
  DeviceWorld world;
  const Row robot = world.addFootbot(1.0, 1.0, 0.4);
  world.addWall({0.1, 2.0, 0.5}, {1.19, 1.0});
  SensorUnderTest<FootbotProximity> own(world, robot);
  SensorUnderTest<Proximity> any(world, robot);
  const auto expectSame = [&](bool is_something) {
    const FootbotProximity& expected = own.sense();
    const Proximity& found = any.sense();
    ASSERT_EQ(found.sensors.size(), FootbotProximity::kCount);
    EXPECT_EQ(expected.value[0] > 0.0F || expected.value[23] > 0.0F, is_something);
    for (std::size_t i = 0; i < FootbotProximity::kCount; ++i) {
      EXPECT_EQ(found.sensors[i].value, expected.value[i]) << "to the last bit, sensor " << i;
      EXPECT_NEAR(std::remainder(found.sensors[i].angle - FootbotProximity::angle(i), 2.0 * M_PI), 0.0, 1e-6) << i;
    }
  };
  expectSame(true);
  world.pose(robot).position.x() = 5.0;
  expectSame(false);
}

TEST(AnyRobotTest, ReadingsStayWhereTheyAreWhenMoreRobotsCome) {
  DeviceWorld world;
  const Row first = world.addFootbot(1.0, 1.0);
  SensorUnderTest<Proximity> ring(world, first);
  const ProximityReading* const readings = ring.sense().sensors.data();
  for (int i = 0; i < 50; ++i) {
    ring.sensor->add(world.space, world.addFootbot(2.0 + 0.1 * i, 3.0));
  }
  EXPECT_EQ(ring.sense().sensors.data(), readings);
}

TEST(AnyRobotTest, LedsThatTheRobotDoesNotHaveAreNotShown) {
  DeviceWorld world;
  const Row robot = world.addFootbot(1.0, 1.0);
  ActuatorUnderTest<Leds> leds(world, robot);
  leds.command.setAll(colors::kGreen);
  leds.command.colors[11] = colors::kRed;
  leds.actuate();
  const Span<const Color> shown = world.space.leds[robot];
  ASSERT_EQ(shown.size(), 12U);
  EXPECT_EQ(shown[0], colors::kGreen);
  EXPECT_EQ(shown[11], colors::kRed);
}

TEST(AnyRobotTest, RobotsWithoutThePartsAreRefused) {
  EXPECT_EQ(refusalOf<ActuatorUnderTest<Wheels>>(robotModel("eyebot")),
            "found the device 'wheels' on a eyebot, allowed: on robots with wheels");
  EXPECT_EQ(refusalOf<ActuatorUnderTest<DifferentialDrive>>(robotModel("handbot")),
            "found the device 'differential_drive' on a handbot, allowed: on robots with wheels");
  auto dark = std::make_shared<EntityModel>(*robotModel("handbot"));
  dark->led_positions.clear();
  EXPECT_EQ(refusalOf<ActuatorUnderTest<Leds>>(dark),
            "found the device 'leds' on a handbot, allowed: on robots with LEDs");
  DeviceWorld world;
  const Row eyebot = world.addEyebot(1.0, 1.0, 1.0);
  EXPECT_THROW(SensorUnderTest<Proximity>(world, eyebot), ConfigError);
}

}  // namespace
}  // namespace swarmanoid::test

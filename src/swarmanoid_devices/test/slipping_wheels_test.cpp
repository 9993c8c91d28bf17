// Slipping wheels, without an engine: the commands to the mechanism, and the conversion of the turns that an engine
// reports.
#include <gtest/gtest.h>

#include <vector>

#include "device_world.hpp"
#include "swarmanoid_interface/devices/differential_drive.hpp"
#include "swarmanoid_interface/devices/footbot_wheels.hpp"
#include "swarmanoid_interface/devices/wheels.hpp"
#include "swarmanoid_interface/testing/count_allocations.hpp"

namespace swarmanoid::test {
namespace {

constexpr double kTick = 0.1;  // s

Parameters slips(const std::string& left, const std::string& right, const std::string& noise) {
  return {{"implementation", "slipping"}, {"slip_left", left}, {"slip_right", right}, {"slip_noise", noise}};
}

/// An engine that reaches wheel speeds at once.
void move(DeviceWorld& world, Row robot) {
  const WheelsCommand& speeds = world.space.wheels[robot];
  world.space.wheel_turns[robot].left += speeds.left * kTick;
  world.space.wheel_turns[robot].right += speeds.right * kTick;
}

TEST(SlippingWheelsTest, TheGroundPassesSlowerAndWheelsTurnAsCommanded) {
  DeviceWorld world;
  const Row robot = world.addFootbot(1.0, 1.0);
  ActuatorUnderTest<FootbotWheels> wheels(world, robot, slips("0.15", "0.04", "0"));
  wheels.command.left = 7.3;
  wheels.command.right = -2.9;
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(wheels.actuate().left, 7.3) << "what is recorded is the command";
    EXPECT_NEAR(world.space.wheels[robot].left, 6.205, 1e-12);
    EXPECT_NEAR(world.space.wheels[robot].right, -2.784, 1e-12);
    move(world, robot);
    wheels.actuator->afterMove(world.space, AfterMoveAccess(world.space));
    ++world.space.tick;
  }
  EXPECT_NEAR(world.space.wheel_turns[robot].left, 2.19, 1e-12);
  EXPECT_NEAR(world.space.wheel_turns[robot].right, -0.87, 1e-12);
}

TEST(SlippingWheelsTest, AreLimitedBeforeTheySlip) {
  DeviceWorld world;
  const Row robot = world.addFootbot(1.0, 1.0);
  ActuatorUnderTest<Wheels> wheels(world, robot, slips("0.2", "0.3", "0"));
  wheels.command.left = wheels.command.right = 100.0;
  wheels.actuate();
  const double fastest = world.space.entities.model[robot]->wheels->max_speed;
  EXPECT_NEAR(world.space.wheels[robot].left, 0.8 * fastest, 1e-12);
  EXPECT_NEAR(world.space.wheels[robot].right, 0.7 * fastest, 1e-12);
}

TEST(SlippingWheelsTest, WhereTheBatteryHasCutThemNothingTurns) {
  DeviceWorld world;
  const Row robot = world.addFootbot(1.0, 1.0);
  ActuatorUnderTest<DifferentialDrive> wheels(world, robot, slips("0.2", "0.3", "0.1"));
  wheels.command.speed = 0.2;
  wheels.actuate();
  world.space.wheels[robot].left = world.space.wheels[robot].right = 0.0;
  move(world, robot);
  wheels.actuator->afterMove(world.space, AfterMoveAccess(world.space));
  EXPECT_EQ(world.space.wheel_turns[robot].left, 0.0);
  EXPECT_EQ(world.space.wheel_turns[robot].right, 0.0);
}

TEST(SlippingWheelsTest, AWheelThatTheEngineHasNotSlowedYetTurnsNoFasterThanItsMotor) {
  DeviceWorld world;
  const Row robot = world.addFootbot(1.0, 1.0);
  ActuatorUnderTest<Wheels> wheels(world, robot, slips("0.97", "0.2", "0"));
  wheels.actuate();
  world.space.wheel_turns[robot] = {-0.4, 0.4};
  wheels.actuator->afterMove(world.space, AfterMoveAccess(world.space));
  const double fastest = world.space.entities.model[robot]->wheels->max_speed;
  EXPECT_NEAR(world.space.wheel_turns[robot].left, -fastest * kTick, 1e-12) << "not 13.3 rad";
  EXPECT_NEAR(world.space.wheel_turns[robot].right, 0.5, 1e-12);
}

TEST(SlippingWheelsTest, NoiseIsDrawnForEachWheelAndTickInProportionToTheSpeed) {
  DeviceWorld world;
  const Row robot = world.addFootbot(1.0, 1.0);
  ActuatorUnderTest<Wheels> wheels(world, robot, slips("0.11", "0.03", "0.07"));
  std::vector<double> left;
  std::vector<double> right;
  std::vector<double> product;
  constexpr int kDraws = 4000;
  for (int i = 0; i < kDraws; ++i) {
    ++world.space.tick;
    wheels.command.left = 6.1;
    wheels.command.right = -1.7;
    wheels.actuate();
    left.push_back(world.space.wheels[robot].left / 6.1);
    right.push_back(world.space.wheels[robot].right / -1.7);
    product.push_back((left.back() - 0.89) * (right.back() - 0.97));
  }
  // tolerances of 4 standard errors
  EXPECT_NEAR(Statistics(left).mean, 0.89, 0.0045);
  EXPECT_NEAR(Statistics(left).deviation, 0.07, 0.0032);
  EXPECT_NEAR(Statistics(right).mean, 0.97, 0.0045);
  EXPECT_NEAR(Statistics(right).deviation, 0.07, 0.0032);
  EXPECT_NEAR(Statistics(product).mean, 0.0, 0.00031) << "the wheels' draws have nothing to do with each other";
}

TEST(SlippingWheelsTest, NoiseNeverTurnsAWheelRound) {
  DeviceWorld world;
  const Row robot = world.addFootbot(1.0, 1.0);
  ActuatorUnderTest<Wheels> wheels(world, robot, slips("0.9", "0.9", "1"));
  wheels.command.left = wheels.command.right = 3.0;
  for (int i = 0; i < 100; ++i) {
    ++world.space.tick;
    wheels.actuate();
    EXPECT_GE(world.space.wheels[robot].left, 0.03);
    EXPECT_GE(world.space.wheels[robot].right, 0.03);
  }
}

TEST(SlippingWheelsTest, NothingIsAllocatedInATick) {
  if (SWARMANOID_COUNTS_ALLOCATIONS == 0) {
    GTEST_SKIP() << "the sanitizer has its own malloc";
  }
  DeviceWorld world;
  const Row robot = world.addFootbot(1.0, 1.0);
  ActuatorUnderTest<Wheels> wheels(world, robot, slips("0.1", "0.2", "0.1"));
  wheels.command.left = 3.0;
  std::vector<Row> faulty;
  const long before = heap_allocations;
  for (int i = 0; i < 10; ++i) {
    ++world.space.tick;
    wheels.actuator->actuate(world.space, ActuateAccess(world.space), faulty);
    wheels.actuator->afterMove(world.space, AfterMoveAccess(world.space));
  }
  EXPECT_EQ(heap_allocations - before, 0);
}

}  // namespace
}  // namespace swarmanoid::test

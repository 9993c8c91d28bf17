// The deep hash covers readings and commands, their owners, and each of their bits.
#include <gtest/gtest.h>

#include "device_world.hpp"
#include "swarmanoid_interface/devices/footbot_proximity.hpp"
#include "swarmanoid_interface/devices/footbot_wheels.hpp"

namespace swarmanoid::test {
namespace {

TEST(DeepHashTest, ACommandChangesItAndNotTheStateHash) {
  DeviceWorld world;
  const Row robot = world.addFootbot(1.0, 1.0);
  ActuatorUnderTest<FootbotWheels> wheels(world, robot);
  const std::uint64_t state = stateHash(world.space);
  const std::uint64_t deep = deepHash(world.space);
  wheels.command.right = 1e-300;
  EXPECT_EQ(stateHash(world.space), state);
  EXPECT_NE(deepHash(world.space), deep);
  wheels.command.right = -0.0;
  EXPECT_NE(deepHash(world.space), deep) << "bit for bit";
  wheels.command.right = 0.0;
  EXPECT_EQ(deepHash(world.space), deep);
}

TEST(DeepHashTest, AReadingChangesIt) {
  DeviceWorld world;
  const Row robot = world.addFootbot(1.0, 1.0);
  SensorUnderTest<FootbotProximity> proximity(world, robot);
  proximity.sense();
  const std::uint64_t deep = deepHash(world.space);
  world.addWall({0.2, 2.0, 1.0}, {1.25, 1.0});
  const std::uint64_t before_sensing = deepHash(world.space);
  EXPECT_NE(before_sensing, deep) << "the wall is state";
  const std::uint64_t state = stateHash(world.space);
  EXPECT_GT(proximity.sense().value[0], 0.0F);
  EXPECT_EQ(stateHash(world.space), state);
  EXPECT_NE(deepHash(world.space), before_sensing);
}

TEST(DeepHashTest, ItKnowsWhoseTheCommandIs) {
  DeviceWorld world;
  ActuatorUnderTest<FootbotWheels> first(world, world.addFootbot(1.0, 1.0));
  ActuatorUnderTest<FootbotWheels> second(world, world.addFootbot(2.0, 1.0));
  first.command.left = 1.0;
  const std::uint64_t deep = deepHash(world.space);
  first.command.left = 0.0;
  second.command.left = 1.0;
  EXPECT_NE(deepHash(world.space), deep);
}

}  // namespace
}  // namespace swarmanoid::test

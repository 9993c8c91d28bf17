// Generic holders of any robot: a footbot's gripper, and a handbot's hands and rope, compared with their specific
// devices.
#include "swarmanoid_interface/devices/holders.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "device_world.hpp"
#include "swarmanoid_experiment_files/robots/robot_model.hpp"
#include "swarmanoid_interface/devices/footbot_gripper.hpp"
#include "swarmanoid_interface/devices/handbot_hands.hpp"
#include "swarmanoid_interface/devices/handbot_rope.hpp"

namespace swarmanoid::test {
namespace {

using HoldersActuator = ActuatorUnderTest<Holders>;
using HoldersSensor = SensorUnderTest<HolderStates>;

// Indices of holders in the handbot's model.
constexpr std::size_t kRightHandHolder = 1;
constexpr std::size_t kRopeHolder = 2;

void expectCommand(const HolderCommand& found, bool holds, double winding_speed) {
  EXPECT_TRUE(found.is_commanded);
  EXPECT_EQ(found.holds, holds);
  EXPECT_EQ(found.winding_speed, winding_speed);
}

std::shared_ptr<EntityModel> spider(std::size_t holders) {
  auto model = std::make_shared<EntityModel>(*robotModel("handbot"));
  model->type = "spider";
  const EntityModel::Holder hand = model->holders[kRightHandHolder];
  model->holders.assign(holders, hand);
  return model;
}

TEST(HoldersTest, CommandAGripperAsItsOwnDeviceDoes) {
  DeviceWorld world;
  const Row with_gripper = world.addFootbot(1.0, 1.0);
  const Row with_holders = world.addFootbot(2.0, 1.0);
  ActuatorUnderTest<FootbotGripper> gripper(world, with_gripper);
  HoldersActuator holders(world, with_holders);
  for (const bool closed : {false, true, false}) {
    gripper.command.closed = closed;
    holders.command.holders[0].holds = closed;
    gripper.actuate();
    holders.actuate();
    ASSERT_EQ(world.space.holder_commands[with_holders].size(), 1U);
    expectCommand(world.space.holder_commands[with_gripper][0], closed, 0.0);
    expectCommand(world.space.holder_commands[with_holders][0], closed, 0.0);
  }
}

TEST(HoldersTest, CommandHandsAndRopeAsTheirOwnDevicesDo) {
  DeviceWorld world;
  const Row own = world.add(robotModel("handbot"), {1.0, 1.0, 0.0});
  const Row any = world.add(robotModel("handbot"), {2.0, 1.0, 0.0});
  ActuatorUnderTest<HandbotHands> hands(world, own);
  ActuatorUnderTest<HandbotRope> rope(world, own);
  HoldersActuator holders(world, any);
  hands.command.right = true;
  rope.command = {true, 0.13};
  holders.command.holders[kRightHandHolder].holds = true;
  holders.command.holders[kRopeHolder] = {true, 0.13};
  holders.command.holders[3] = {true, 0.2};  // the robot does not have it
  const auto expectSame = [&](double winding_speed) {
    hands.actuate();
    rope.actuate();
    holders.actuate();
    for (const Row row : {own, any}) {
      const Span<const HolderCommand> commands = world.space.holder_commands[row];
      ASSERT_EQ(commands.size(), 3U);
      expectCommand(commands[0], false, 0.0);
      expectCommand(commands[kRightHandHolder], true, 0.0);
      expectCommand(commands[kRopeHolder], true, winding_speed);
    }
  };
  expectSame(0.13);
  rope.command.winding_speed = -7.0;
  holders.command.holders[kRopeHolder].winding_speed = -7.0;
  expectSame(-0.2);
}

TEST(HoldersTest, TheFastestWindingIsAParameter) {
  DeviceWorld world;
  const Row robot = world.add(robotModel("handbot"), {1.0, 1.0, 0.0});
  HoldersActuator holders(world, robot, {{"max_speed", "0.35"}}, {bias("holders[2].winding_speed", "-0.25")});
  holders.command.holders[kRopeHolder] = {true, 0.5};
  EXPECT_EQ(holders.actuate().holders[kRopeHolder].winding_speed, 0.25) << "with its error";
  holders.command.holders[kRopeHolder].winding_speed = 0.9;
  EXPECT_EQ(holders.actuate().holders[kRopeHolder].winding_speed, 0.35);
}

TEST(HoldersTest, ASafeStopKeepsHoldOfWhatIsHeld) {
  DeviceWorld world;
  const Row robot = world.add(robotModel("handbot"), {1.0, 1.0, 0.0});
  HoldersActuator holders(world, robot);
  holders.command.holders[0].holds = true;
  holders.command.holders[kRopeHolder] = {true, 0.1};
  holders.actuate();
  holders.command.holders[kRopeHolder].winding_speed = std::numeric_limits<double>::quiet_NaN();
  holders.actuate();
  EXPECT_EQ(holders.faulty, std::vector<Row>{robot});
  EXPECT_TRUE(holders.stop());
  holders.actuate();
  EXPECT_TRUE(holders.faulty.empty());
  expectCommand(world.space.holder_commands[robot][0], true, 0.0);
  expectCommand(world.space.holder_commands[robot][kRightHandHolder], false, 0.0);
  expectCommand(world.space.holder_commands[robot][kRopeHolder], true, 0.0);
}

TEST(HolderStatesTest, AGripperHoldsWhatIsInTheStructuralTree) {
  DeviceWorld world;
  const Row robot = world.addFootbot(1.0, 1.0);
  const Row other = world.addFootbot(2.0, 1.0);
  const Row prey = world.addPrey(1.2, 1.0);
  HoldersSensor states(world, robot);
  ASSERT_EQ(states.sense().holders.size(), 1U);
  EXPECT_FALSE(states.sense().holders[0].is_holding);
  world.space.structure.connect(robot, prey);
  EXPECT_TRUE(states.sense().holders[0].is_holding);
  EXPECT_EQ(states.sense().holders[0].force, 0.0);
  world.space.structure.release(robot);
  world.space.structure.connect(other, robot);
  EXPECT_FALSE(states.sense().holders[0].is_holding) << "being gripped is not gripping";
}

TEST(HolderStatesTest, OthersHoldWhatIsAttached) {
  DeviceWorld world;
  const Row robot = world.add(robotModel("handbot"), {1.0, 1.0, 0.0});
  const Row ceiling = world.addWall({1.0, 1.0, 0.1}, {1.0, 1.0});
  const Row prey = world.addPrey(1.3, 1.0);
  HoldersSensor states(world, robot);
  world.space.attachments.attach(robot, kRopeHolder, {ceiling, {0.0, 0.0, 0.0}, 1.25, 28.5});
  world.space.attachments.attach(robot, kRightHandHolder, {prey, {0.0, 0.0, 0.0}, 0.0, 2.5});
  const Span<const HolderStates::Holder> holders = states.sense().holders;
  ASSERT_EQ(holders.size(), 3U);
  EXPECT_FALSE(holders[0].is_holding);
  EXPECT_EQ(holders[0].force, 0.0);
  EXPECT_TRUE(holders[kRightHandHolder].is_holding);
  EXPECT_EQ(holders[kRightHandHolder].length, 0.0);
  EXPECT_EQ(holders[kRightHandHolder].force, 2.5);
  EXPECT_TRUE(holders[kRopeHolder].is_holding);
  EXPECT_EQ(holders[kRopeHolder].length, 1.25);
  EXPECT_EQ(holders[kRopeHolder].force, 28.5);
  world.space.attachments.detach(robot, kRopeHolder);
  EXPECT_FALSE(states.sense().holders[kRopeHolder].is_holding);
  EXPECT_EQ(states.sense().holders[kRopeHolder].length, 0.0);
}

TEST(HolderStatesTest, ErrorsActOnTheSpan) {
  DeviceWorld world;
  const Row robot = world.add(robotModel("handbot"), {1.0, 1.0, 0.0});
  const Row prey = world.addPrey(1.3, 1.0);
  HoldersSensor states(world, robot, {}, {bias("holders[].force", "0.75")});
  world.space.attachments.attach(robot, kRightHandHolder, {prey, {0.0, 0.0, 0.0}, 0.0, 2.5});
  EXPECT_EQ(states.sense().holders[kRightHandHolder].force, 3.25);
  EXPECT_EQ(states.sense().holders[0].force, 0.75);
  EXPECT_EQ(states.sense().holders[kRightHandHolder].length, 0.0);
}

TEST(HoldersTest, RobotsWithoutHoldersOrWithTooManyAreRefused) {
  EXPECT_EQ(refusalOf<HoldersActuator>(spider(8)), "");
  EXPECT_EQ(refusalOf<HoldersActuator>(spider(0)),
            "found the device 'holders' on a spider, allowed: on robots with holders");
  EXPECT_EQ(refusalOf<HoldersActuator>(spider(9)),
            "found the device 'holders' on a spider with 9 holders, allowed: on robots with 1 to 8");
  EXPECT_EQ(refusalOf<HoldersSensor>(spider(0)),
            "found the device 'holder_states' on a spider, allowed: on robots with holders");
  EXPECT_EQ(refusalOf<HoldersSensor>(spider(9)),
            "found the device 'holder_states' on a spider with 9 holders, allowed: on robots with 1 to 8");
}

}  // namespace
}  // namespace swarmanoid::test

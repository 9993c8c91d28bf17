// The sensors in a handbot's palms: proximity, and the vacuum in each cup. With arms stretched ahead the palms are
// 0.205 m ahead of the origin, 0.11 m aside and 0.15 m above it.
#include <gtest/gtest.h>

#include <cmath>

#include "device_world.hpp"
#include "swarmanoid_experiment_files/robots/robot_model.hpp"
#include "swarmanoid_interface/devices/handbot_hands.hpp"
#include "swarmanoid_interface/devices/handbot_proximity.hpp"
#include "swarmanoid_interface/devices/handbot_vacuum.hpp"
#include "swarmanoid_space/device_drawing.hpp"

namespace swarmanoid::test {
namespace {

constexpr double kPalm = 0.205;  // m

/// A handbot at (2, 3), and ahead of its left hand a brick. Its near face is `gap` from the palm, and its left face
/// `left` to the left of the robot's axis.
struct Palms {
  explicit Palms(double gap, double left = 0.3, std::shared_ptr<const EntityModel> model = robotModel("handbot")) {
    robot = world.add(std::move(model), {2.0, 3.0, 0.0});
    world.add(blockModel({0.1, left, 0.4}), {2.0 + kPalm + gap + 0.05, 3.0 + 0.5 * left, 0.2});
  }

  DeviceWorld world;
  Row robot = kNoRow;
};

TEST(HandbotProximityTest, FeelsWhatIsAheadOfAPalm) {
  Palms palms(0.037);
  const HandbotProximity& reading = SensorUnderTest<HandbotProximity>(palms.world, palms.robot).sense();
  EXPECT_NEAR(reading.left, 0.250047, 1e-6);  // (1 - 0.37)^3
  EXPECT_EQ(reading.right, 0.0F) << "the brick ends in the middle";
}

TEST(HandbotProximityTest, MovesWithTheArm) {
  Palms palms(0.037);
  const int shoulder = robotModel("handbot")->findJoint("left_shoulder");
  palms.world.space.joints[palms.robot][static_cast<std::size_t>(shoulder)].angle = 0.25;
  SensorUnderTest<HandbotProximity> sensor(palms.world, palms.robot, {{"range", "0.13"}});
  // the palm is 0.03 + 0.175 cos 0.25 = 0.199560 m ahead and looks 0.25 rad down: 0.042440 / cos 0.25 = 0.043802 m
  EXPECT_NEAR(sensor.sense().left, std::pow(1.0 - 0.0438020 / 0.13, 3), 1e-5);
  palms.world.pose(palms.robot).position.x() -= 0.1;
  EXPECT_EQ(sensor.sense().left, 0.0F);
}

TEST(HandbotProximityTest, ItsRaysAreDrawnAsFarAsTheyReach) {
  Palms palms(0.037);
  SensorUnderTest<HandbotProximity> sensor(palms.world, palms.robot);
  sensor.sense();
  DeviceDrawing drawing;
  sensor.sensor->draw(palms.world.space, drawing);
  ASSERT_EQ(drawing.lines().size(), 2U);
  EXPECT_LT((drawing.lines()[0].from - Eigen::Vector3d(2.205, 3.11, 0.15)).norm(), 1e-9);
  EXPECT_LT((drawing.lines()[0].to - Eigen::Vector3d(2.242, 3.11, 0.15)).norm(), 1e-9);
  EXPECT_LT((drawing.lines()[1].to - Eigen::Vector3d(2.305, 2.89, 0.15)).norm(), 1e-9);
  EXPECT_EQ(drawing.lines()[1].color, DeviceDrawing::shade(0.0));
}

TEST(HandbotVacuumTest, IsReachedInCupsThatLieOnSomething) {
  // Cup 0 is 0.128 m to the left of the axis, cup 1 is 0.092 m; the brick ends at 0.132 m. The centre of cup 0, and the
  // five points of its lip that are at most 0.004 m to the left of the centre, are on the brick: six of nine.
  Palms palms(0.006, 0.132);
  SensorUnderTest<HandbotVacuum> vacuum(palms.world, palms.robot);
  ActuatorUnderTest<HandbotHands> hands(palms.world, palms.robot);
  hands.actuate();
  EXPECT_EQ(vacuum.sense().left[1], 0.0F) << "suction is off";
  hands.command.left = true;
  hands.command.right = true;
  hands.actuate();
  const HandbotVacuum& reading = vacuum.sense();
  EXPECT_FLOAT_EQ(reading.left[0], 6.0F / 9.0F);
  EXPECT_EQ(reading.left[1], 1.0F);
  EXPECT_EQ(reading.left[2], 0.0F) << "it has two";
  EXPECT_EQ(reading.right[0], 0.0F);
  DeviceDrawing drawing;
  vacuum.sensor->draw(palms.world.space, drawing);
  ASSERT_EQ(drawing.lines().size() % 4, 0U) << "four lips";
  EXPECT_EQ(drawing.lines().front().color, DeviceDrawing::shade(static_cast<double>(6.0F / 9.0F)));
  EXPECT_NEAR((drawing.lines().front().from - Eigen::Vector3d(2.205, 3.128, 0.15)).norm(), 0.011, 1e-9);
  palms.world.pose(palms.robot).position.x() -= 0.0041;
  EXPECT_EQ(vacuum.sense().left[1], 0.0F) << "10.1 mm before it";
}

TEST(HandbotVacuumTest, HandsMayHaveFourCups) {
  auto model = std::make_shared<EntityModel>(*robotModel("handbot"));
  for (const std::string side : {"left", "right"}) {
    for (const int cup : {0, 1}) {
      Mount mount = model->mounts.at(side + "_cup_" + std::to_string(cup));
      mount.position.z() += 0.03;
      model->mounts[side + "_cup_" + std::to_string(cup + 2)] = mount;
    }
  }
  Palms palms(0.003, 0.3, model);
  SensorUnderTest<HandbotVacuum> vacuum(palms.world, palms.robot);
  ActuatorUnderTest<HandbotHands> hands(palms.world, palms.robot);
  hands.command.left = true;
  hands.actuate();
  EXPECT_EQ(vacuum.sense().left, (std::array<float, 4>{1.0F, 1.0F, 1.0F, 1.0F}));
  EXPECT_EQ(vacuum.sense().right, (std::array<float, 4>{}));
}

TEST(HandbotVacuumTest, ARobotWithoutCupsIsRefused) {
  auto model = std::make_shared<EntityModel>(*robotModel("handbot"));
  model->mounts.erase("right_cup_0");
  Palms palms(0.006, 0.3, model);
  EXPECT_THROW(SensorUnderTest<HandbotVacuum>(palms.world, palms.robot), ConfigError);
}

}  // namespace
}  // namespace swarmanoid::test

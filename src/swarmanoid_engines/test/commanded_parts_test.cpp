// Combinations of devices that engines accept: one device commands a joint or a holder, and devices that work with all
// of a robot's parts count as users of each of them.
#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "dynamics2d/dynamics2d.hpp"
#include "dynamics3d/dynamics3d.hpp"
#include "kinematics2d/kinematics2d.hpp"
#include "swarmanoid_experiment_files/robots/robot_model.hpp"

namespace swarmanoid {
namespace {

using Kind = Mechanism::Kind;

DeviceUse actuator(const std::string& type, const Mechanism& mechanism) {
  return {type, {mechanism}, DeviceKind::kActuator};
}

const DeviceUse kTurret = actuator("footbot_turret", {Kind::kJoint, "turret"});
const DeviceUse kTurretState{"footbot_turret_state", {{Kind::kJoint, "turret"}}};
const DeviceUse kJoints = actuator("joints", {Kind::kJoint});
const DeviceUse kGripper = actuator("footbot_gripper", {Kind::kHolder, "gripper"});
const DeviceUse kHolders = actuator("holders", {Kind::kHolder});

class CommandedPartsTest : public testing::Test {
 protected:
  void expect(const std::string& robot, const std::vector<DeviceUse>& devices, const std::string& reason) const {
    for (const auto& engine : engines_) {
      EXPECT_EQ(engine->unsupportedReason(*robotModel(robot), devices), reason);
    }
  }

 private:
  std::vector<std::shared_ptr<Engine>> engines_{std::make_shared<kinematics2d::Kinematics2d>(),
                                                std::make_shared<dynamics2d::Dynamics2d>(),
                                                std::make_shared<dynamics3d::Dynamics3d>()};
};

TEST_F(CommandedPartsTest, OneDeviceCommandsAJointAndOthersReadIt) {
  expect("footbot", {kTurretState, kTurret, kGripper}, "");
  expect("footbot", {kTurretState, kJoints, kGripper}, "");
  expect(
      "footbot", {kTurretState, kTurret, kJoints},
      "device 'joints' cannot be simulated: the device 'footbot_turret' commands the robot's joint 'turret' already");
  expect(
      "footbot", {kJoints, kTurret},
      "device 'footbot_turret' cannot be simulated: the device 'joints' commands the robot's joint 'turret' already");
  expect("footbot", {kJoints, kGripper, actuator("my_joints", {Kind::kJoint})},
         "device 'my_joints' cannot be simulated: the device 'joints' commands the robot's joints already");
}

TEST_F(CommandedPartsTest, OneDeviceDrivesTheRobotAndOthersMeasureIt) {
  const DeviceUse encoders{"wheel_encoders", {{Kind::kWheels}}};
  const DeviceUse odometry{"odometry", {{Kind::kWheels}}};
  expect("footbot", {encoders, actuator("footbot_wheels", {Kind::kWheels}), odometry}, "");
  expect("footbot", {encoders, odometry}, "");
  expect("eyebot", {odometry}, "device 'odometry' cannot be simulated: a robot of this type has no wheels");
  expect("eyebot", {actuator("eyebot_velocity", {Kind::kFlight}), actuator("eyebot_position", {Kind::kFlight})},
         "device 'eyebot_position' cannot be simulated: another device drives the robot already");
}

TEST_F(CommandedPartsTest, OneDeviceCommandsAHolder) {
  expect("footbot", {kJoints, kHolders}, "");
  expect("footbot", {kGripper, kHolders},
         "device 'holders' cannot be simulated: the device 'footbot_gripper' commands the robot's holder 'gripper' "
         "already");
}

TEST_F(CommandedPartsTest, RobotsWithoutAnySuchPartAreRefused) {
  expect("eyebot", {kJoints}, "device 'joints' cannot be simulated: a robot of this type has no joints");
}

TEST(CommandedPartsInAPlaneTest, OnlyATurretAndAGripperCanBeSimulated) {
  const kinematics2d::Kinematics2d plane;
  const dynamics3d::Dynamics3d space;
  EXPECT_FALSE(plane.mayStandIdle(*robotModel("footbot"), kJoints));
  EXPECT_FALSE(plane.mayStandIdle(*robotModel("footbot"), kHolders));
  for (const DeviceUse& device : {kJoints, kHolders}) {
    EXPECT_EQ(plane.unsupportedReason(*robotModel("handbot"), {device}),
              "device '" + device.type + "' cannot be simulated in a plane");
    EXPECT_TRUE(plane.mayStandIdle(*robotModel("handbot"), device));
    EXPECT_EQ(space.unsupportedReason(*robotModel("handbot"), {device}), "");
  }
  EXPECT_EQ(plane.unsupportedReason(*robotModel("eyebot"), {kHolders}),
            "device 'holders' cannot be simulated in a plane");
}

/// In three dimensions, a link that an arm turns is a rigid body of its own, and a gripper turns only with a turret.
TEST(CommandedPartsInSpaceTest, AGripperOnATurretIsRefusedBesideAnArm) {
  const dynamics3d::Dynamics3d space;
  auto model = std::make_shared<EntityModel>(*robotModel("footbot"));
  EntityModel::Joint shoulder = model->joints.front();
  shoulder.name = "shoulder";
  shoulder.axis = Eigen::Vector3d::UnitY();
  model->joints.push_back(shoulder);
  EXPECT_EQ(space.unsupportedReason(*model, {kTurret, kGripper}), "");
  EXPECT_EQ(space.unsupportedReason(*model, {kJoints}), "");
  EXPECT_EQ(space.unsupportedReason(*model, {kJoints, kGripper}),
            "device 'footbot_gripper' cannot be simulated: the gripper is on a link, and joints besides a turret are "
            "commanded");
}

}  // namespace
}  // namespace swarmanoid

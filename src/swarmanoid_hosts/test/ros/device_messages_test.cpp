// Converts devices to messages and back.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "swarmanoid_hosts/ros/device_topic.hpp"
#include "swarmanoid_hosts/ros/devices/color_blob_camera.hpp"
#include "swarmanoid_hosts/ros/devices/differential_drive.hpp"
#include "swarmanoid_hosts/ros/devices/eyebot_laser.hpp"
#include "swarmanoid_hosts/ros/devices/eyebot_magnet.hpp"
#include "swarmanoid_hosts/ros/devices/eyebot_velocity.hpp"
#include "swarmanoid_hosts/ros/devices/footbot_gripper.hpp"
#include "swarmanoid_hosts/ros/devices/footbot_ground.hpp"
#include "swarmanoid_hosts/ros/devices/footbot_proximity.hpp"
#include "swarmanoid_hosts/ros/devices/footbot_turret.hpp"
#include "swarmanoid_hosts/ros/devices/footbot_wheels.hpp"
#include "swarmanoid_hosts/ros/devices/ground.hpp"
#include "swarmanoid_hosts/ros/devices/handbot_arms.hpp"
#include "swarmanoid_hosts/ros/devices/handbot_hands.hpp"
#include "swarmanoid_hosts/ros/devices/handbot_rope.hpp"
#include "swarmanoid_hosts/ros/devices/holders.hpp"
#include "swarmanoid_hosts/ros/devices/imu.hpp"
#include "swarmanoid_hosts/ros/devices/joints.hpp"
#include "swarmanoid_hosts/ros/devices/led_array.hpp"
#include "swarmanoid_hosts/ros/devices/leds.hpp"
#include "swarmanoid_hosts/ros/devices/light.hpp"
#include "swarmanoid_hosts/ros/devices/proximity.hpp"
#include "swarmanoid_hosts/ros/devices/range_and_bearing.hpp"
#include "swarmanoid_hosts/ros/devices/wheels.hpp"
#include "swarmanoid_interface/device_type.hpp"

namespace swarmanoid {
namespace {

/// Converts to a message and back, to a device with its initial value.
template <class Message, class Device>
Device thereAndBack(const Device& device) {
  Message message;
  toMessage(device, message);
  Device back;
  fromMessage(message, back);
  return back;
}

Bytes bytesOf(const std::string& type, const void* device) {
  Bytes bytes;
  ByteWriter writer(bytes);
  findDeviceType(type)->write(device, writer);
  return bytes;
}

template <class Message, class Device>
void expectNothingLost(const Device& device) {
  const Device back = thereAndBack<Message>(device);
  EXPECT_NE(bytesOf(Device::kType, std::make_unique<Device>().get()), bytesOf(Device::kType, &device));
  EXPECT_EQ(bytesOf(Device::kType, &device), bytesOf(Device::kType, &back)) << Device::kType;
}

template <class Message, class Device>
std::string refusalOf(const Message& message, Device device = {}) {
  const Bytes before = bytesOf(Device::kType, &device);
  VariableParts parts;
  try {
    detail::receive(message, device, parts);
  } catch (const std::exception& error) {
    EXPECT_EQ(before, bytesOf(Device::kType, &device));
    return error.what();
  }
  return "";
}

TEST(DeviceMessages, KeepAllReadings) {
  FootbotProximity proximity;
  for (std::size_t i = 0; i < FootbotProximity::kCount; ++i) {
    proximity.value[i] = 0.01F * static_cast<float>(i);
  }
  expectNothingLost<swarmanoid_msgs::ProximityArray>(proximity);
  expectNothingLost<swarmanoid_msgs::GroundArray>(FootbotGround{{0.1F, 0.2F, 0.3F, 0.4F, 0.5F, 0.6F, 0.7F, 0.8F}});
  expectNothingLost<swarmanoid_msgs::GroundArray>(FootbotBaseGround{{0.5F, 0.0F, 1.0F, 0.25F}});
  expectNothingLost<swarmanoid_msgs::GripperState>(FootbotGripperState{true});
  expectNothingLost<sensor_msgs::JointState>(FootbotTurretState{0.1, 0.2, 0.3});
  expectNothingLost<swarmanoid_msgs::GripperState>(EyebotMagnetState{true});
  expectNothingLost<swarmanoid_msgs::HandsState>(HandbotHandsState{{true, 1.5}, {false, 2.5}});
  expectNothingLost<swarmanoid_msgs::RopeState>(HandbotRopeState{true, 1.25, 7.5});
  HandbotArmsState arms;
  for (std::size_t i = 0; i < HandbotArmsState::kJoints; ++i) {
    arms.joints[i] = {0.1 * static_cast<double>(i), 1.0, -static_cast<double>(i)};
  }
  expectNothingLost<sensor_msgs::JointState>(arms);
}

TEST(DeviceMessages, KeepAllBlobs) {
  const std::array<ColorBlob, 2> blobs{ColorBlob{{255, 0, 1}, 0.5F, 1.5F}, ColorBlob{{3, 2, 255}, -3.0F, 0.25F}};
  FootbotCamera camera;
  camera.blobs = Span<const ColorBlob>(blobs.data(), blobs.size());
  camera.overflowed = true;
  swarmanoid_msgs::ColorBlobs message;
  toMessage(camera, message);
  FootbotCamera back;
  VariableParts parts;
  fromMessage(message, back, parts);
  EXPECT_EQ(bytesOf("footbot_camera", &camera), bytesOf("footbot_camera", &back));
}

TEST(DeviceMessages, KeepProximityOfAnyRobot) {
  const std::array<ProximityReading, 2> sensors{ProximityReading{0.25F, 0.5F}, ProximityReading{1.0F, -3.0F}};
  Proximity proximity;
  proximity.sensors = Span<const ProximityReading>(sensors.data(), sensors.size());
  swarmanoid_msgs::ProximityArray message;
  toMessage(proximity, message);
  EXPECT_EQ(message.angles, (std::vector<float>{0.5F, -3.0F}));
  Proximity back;
  VariableParts parts;
  fromMessage(message, back, parts);
  EXPECT_EQ(bytesOf("proximity", &proximity), bytesOf("proximity", &back));
  message.angles.pop_back();
  EXPECT_EQ(refusalOf(message, proximity), "found 1 angles and 2 values, allowed: as many of both, at most 64");
}

TEST(DeviceMessages, KeepLightOfAnyRobot) {
  const std::array<LightReading, 2> sensors{LightReading{0.125F, -0.5F}, LightReading{1.0F, 3.0F}};
  Light light;
  light.sensors = Span<const LightReading>(sensors.data(), sensors.size());
  swarmanoid_msgs::LightArray message;
  toMessage(light, message);
  EXPECT_EQ(message.values, (std::vector<float>{0.125F, 1.0F}));
  Light back;
  VariableParts parts;
  fromMessage(message, back, parts);
  EXPECT_EQ(bytesOf("light", &light), bytesOf("light", &back));
  message.values.resize(65);
  message.angles.resize(65);
  EXPECT_EQ(refusalOf(message, light), "found 65 angles and 65 values, allowed: as many of both, at most 64");
}

TEST(DeviceMessages, KeepTheGroundUnderAnyRobot) {
  const std::array<GroundSpot, 2> spots{GroundSpot{0.125F, 0.03F, -0.02F}, GroundSpot{1.0F, -0.03F, 0.01F}};
  Ground ground;
  ground.spots = Span<const GroundSpot>(spots.data(), spots.size());
  swarmanoid_msgs::GroundArray message;
  toMessage(ground, message);
  EXPECT_EQ(message.x, (std::vector<float>{0.03F, -0.03F}));
  EXPECT_EQ(message.y, (std::vector<float>{-0.02F, 0.01F}));
  Ground back;
  VariableParts parts;
  fromMessage(message, back, parts);
  EXPECT_EQ(bytesOf("ground", &ground), bytesOf("ground", &back));
  message.y.pop_back();
  EXPECT_EQ(refusalOf(message, ground), "found 2 x, 1 y and 2 values, allowed: as many of each, at most 64");
}

TEST(DeviceMessages, OfFootbotsGroundSayWhereTheSpotsAre) {
  swarmanoid_msgs::GroundArray message;
  toMessage(FootbotGround{}, message);
  ASSERT_EQ(message.x.size(), 8U);
  // spot 5 is at 247.5 degrees
  EXPECT_NEAR(message.x[5], -0.02410906, 1e-7);
  EXPECT_NEAR(message.y[5], -0.05820441, 1e-7);
  EXPECT_EQ("found 8 values, expected 4", (refusalOf(message, FootbotBaseGround{})));
  toMessage(FootbotBaseGround{}, message);
  EXPECT_EQ(message.x, (std::vector<float>{0.03F, -0.03F, -0.03F, 0.03F}));
  EXPECT_EQ(message.y, (std::vector<float>{0.03F, 0.03F, -0.03F, -0.03F}));
  EXPECT_EQ("found 4 values, expected 8", (refusalOf(message, FootbotGround{})));
}

TEST(DeviceMessages, KeepJointsOfAnyRobotInTheirOrder) {
  Joints command;
  command.joints[0].holdAngle(0.25);
  command.joints[15].turnAt(-0.5);
  expectNothingLost<swarmanoid_msgs::JointsCommand>(command);
  const std::array<JointStates::Joint, 2> joints{JointStates::Joint{0.1, -0.2, 0.3},
                                                 JointStates::Joint{-1.0, 2.0, 0.5}};
  JointStates states;
  states.joints = Span<const JointStates::Joint>(joints.data(), joints.size());
  sensor_msgs::JointState message;
  message.name = {"of another message"};
  toMessage(states, message);
  EXPECT_TRUE(message.name.empty());
  EXPECT_EQ((std::vector<double>{-0.2, 2.0}), message.velocity);
  JointStates back;
  VariableParts parts;
  fromMessage(message, back, parts);
  EXPECT_EQ(bytesOf("joint_states", &states), bytesOf("joint_states", &back));
  message.name = {"elbow", "shoulder"};
  EXPECT_EQ("found 2 names, allowed: none, joints are known by their order here", refusalOf(message, states));
  message.name.clear();
  message.effort.pop_back();
  EXPECT_EQ("found 2 positions, 2 velocities and 1 efforts, allowed: as many of each, at most 16",
            refusalOf(message, states));
}

TEST(DeviceMessages, JointsBeyondTheMessageKeepTheirCommands) {
  Joints command;
  command.joints[1].holdAngle(0.75);
  swarmanoid_msgs::JointsCommand message;
  message.modes = {2};
  message.angles = {0.0};
  message.speeds = {0.0};
  fromMessage(message, command);
  EXPECT_EQ(Joints::Mode::kPassive, command.joints[0].mode);
  EXPECT_EQ(0.75, command.joints[1].angle);
  message.modes = {3};
  EXPECT_EQ("found mode 3 of joint 0, allowed: 0 (ANGLE), 1 (SPEED), 2 (PASSIVE)", refusalOf(message, command));
  message.modes = {0, 0};
  EXPECT_EQ("found 2 modes, 1 angles and 1 speeds, allowed: as many of each, at most 16", refusalOf(message, command));
}

TEST(DeviceMessages, KeepHoldersOfAnyRobot) {
  Holders command;
  command.holders[0].holds = true;
  command.holders[7].winding_speed = -0.125;
  expectNothingLost<swarmanoid_msgs::HoldersCommand>(command);
  swarmanoid_msgs::HoldersCommand shorter;
  shorter.holds = {0};
  shorter.winding_speeds = {0.5};
  fromMessage(shorter, command);
  EXPECT_FALSE(command.holders[0].holds);
  EXPECT_EQ(-0.125, command.holders[7].winding_speed) << "beyond the message";
  shorter.holds.resize(9);
  shorter.winding_speeds.resize(9);
  EXPECT_EQ("found 9 holds and 9 winding_speeds, allowed: as many of both, at most 8", refusalOf(shorter, command));

  const std::array<HolderStates::Holder, 2> holders{HolderStates::Holder{false, 0.0, 0.0},
                                                    HolderStates::Holder{true, 1.25, 28.5}};
  HolderStates states;
  states.holders = Span<const HolderStates::Holder>(holders.data(), holders.size());
  swarmanoid_msgs::HoldersState message;
  toMessage(states, message);
  EXPECT_EQ((std::vector<double>{0.0, 28.5}), message.forces);
  HolderStates back;
  VariableParts parts;
  fromMessage(message, back, parts);
  EXPECT_EQ(bytesOf("holder_states", &states), bytesOf("holder_states", &back));
  message.lengths.pop_back();
  EXPECT_EQ("found 2 is_holding, 1 lengths and 2 forces, allowed: as many of each, at most 8",
            refusalOf(message, states));
}

TEST(DeviceMessages, OfInertialUnitsSayWhatIsNotMeasured) {
  Imu imu;
  imu.angular_velocity = {0.1, -0.2, 0.3};
  imu.linear_acceleration = {-1.5, 2.5, 9.0};
  expectNothingLost<sensor_msgs::Imu>(imu);
  sensor_msgs::Imu message;
  toMessage(imu, message);
  EXPECT_EQ(-1.0, message.orientation_covariance[0]);
  EXPECT_EQ(0.3, message.angular_velocity.z);
  EXPECT_EQ(2.5, message.linear_acceleration.y);
  message.orientation_covariance[0] = 0.01;
  EXPECT_EQ("", refusalOf(message, imu)) << "one that measures it too";
}

TEST(DeviceMessages, OfInertialUnitsWithoutAccelerometersAreRefused) {
  sensor_msgs::Imu message;
  message.linear_acceleration_covariance[0] = -1.0;
  EXPECT_EQ("found linear_acceleration_covariance[0] = -1 (not measured), allowed: 0 or more",
            refusalOf(message, Imu{}));
}

TEST(DeviceMessages, LedsWithoutAColourAreOff) {
  swarmanoid_msgs::LedArray message;
  message.colors.resize(2, toMessage(colors::kRed));
  Leds leds;
  leds.setAll(colors::kBlue);
  fromMessage(message, leds);
  EXPECT_EQ(leds.colors[1], colors::kRed);
  EXPECT_EQ(leds.colors[2], colors::kBlack);
  message.colors.resize(65);
  EXPECT_EQ(refusalOf(message, leds), "found 65 colours, allowed: at most 64");
}

TEST(DeviceMessages, KeepWhatIsSentByRangeAndBearing) {
  RangeAndBearing command;
  command.send({255, 0, 1, 2, 3, 4, 5, 6, 7, 128});
  expectNothingLost<swarmanoid_msgs::MessageCommand>(command);
  swarmanoid_msgs::MessageCommand message;
  message.payload = {9, 8};
  message.sends = 1;
  fromMessage(message, command);
  EXPECT_EQ(command.payload, (RangeAndBearing::Payload{9, 8})) << "what is missing is 0";
  EXPECT_TRUE(command.sends);
  message.payload.resize(11);
  EXPECT_EQ(refusalOf(message, command), "found a payload of 11 bytes, allowed: at most 10");
}

TEST(DeviceMessages, KeepWhatIsReceivedByRangeAndBearing) {
  std::array<RangeAndBearingMessage, 2> messages;
  messages[0] = {1.5F, -2.5F, 0.25F, {1, 2, 3, 4, 5, 6, 7, 8, 9, 255}};
  messages[1] = {0.125F, 3.0F, -1.25F, {128}};
  RangeAndBearingReceived received;
  received.messages = Span<const RangeAndBearingMessage>(messages.data(), messages.size());
  received.overflowed = true;
  swarmanoid_msgs::RangeAndBearingMessages message;
  toMessage(received, message);
  ASSERT_EQ(2U, message.messages.size());
  EXPECT_EQ(-1.25F, message.messages[1].elevation);
  EXPECT_EQ(255, message.messages[0].payload.at(9));
  RangeAndBearingReceived back;
  VariableParts parts;
  fromMessage(message, back, parts);
  EXPECT_EQ(bytesOf("range_and_bearing_received", &received), bytesOf("range_and_bearing_received", &back));
  message.messages[1].payload.resize(12);
  EXPECT_EQ(refusalOf(message, received), "found a payload of 12 bytes, allowed: at most 10");
  message.messages[1].payload.clear();
  message.messages[1].range = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(refusalOf(message, received), "found a number that is not finite, allowed: finite numbers");
  message.messages.resize(65);
  EXPECT_EQ(refusalOf(message, received), "found 65 messages, allowed: at most 64");
}

TEST(DeviceMessages, ARefusedListLeavesTheFormerOne) {
  swarmanoid_msgs::ColorBlobs message;
  message.blobs.resize(2);
  message.blobs[1].bearing = 0.75F;
  FootbotCamera camera;
  VariableParts parts;
  detail::receive(message, camera, parts);
  message.blobs.resize(500);
  message.blobs[499].distance = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THROW(detail::receive(message, camera, parts), std::runtime_error);
  ASSERT_EQ(2U, camera.blobs.size());
  EXPECT_EQ(0.75F, camera.blobs[1].bearing);
}

TEST(DeviceMessages, KeepAllCommands) {
  expectNothingLost<swarmanoid_msgs::WheelsCommand>(FootbotWheels{1.5, -2.5});
  expectNothingLost<swarmanoid_msgs::WheelsCommand>(Wheels{1.5, -2.5});
  expectNothingLost<geometry_msgs::Twist>(DifferentialDrive{0.25, -0.5});
  expectNothingLost<swarmanoid_msgs::GripperCommand>(FootbotGripper{true});
  expectNothingLost<swarmanoid_msgs::TurretCommand>(FootbotTurret{FootbotTurret::Mode::kSpeed, 0.25, -0.5});
  expectNothingLost<swarmanoid_msgs::TurretCommand>(FootbotTurret{FootbotTurret::Mode::kPassive, 0.0, 0.0});
  expectNothingLost<geometry_msgs::Twist>(EyebotVelocity{{0.1, 0.2, 0.3}, 0.4});
  expectNothingLost<swarmanoid_msgs::LaserCommand>(EyebotLaser{true, 0.5, -0.25});
  expectNothingLost<swarmanoid_msgs::GripperCommand>(EyebotMagnet{true});
  expectNothingLost<sensor_msgs::JointState>(HandbotArms{{0.1, 0.2, 0.3}, {0.4, 0.5, 0.6}});
  expectNothingLost<swarmanoid_msgs::HandsCommand>(HandbotHands{true, false});
  expectNothingLost<swarmanoid_msgs::RopeCommand>(HandbotRope{true, -0.25});
  FootbotLeds footbot;
  footbot.ring[3] = {255, 128, 1};
  expectNothingLost<swarmanoid_msgs::LedArray>(footbot);
  EyebotLeds eyebot;
  eyebot.ring[15] = colors::kRed;
  expectNothingLost<swarmanoid_msgs::LedArray>(eyebot);
}

TEST(DeviceMessages, AFootbotIsDrivenByATwistToo) {
  geometry_msgs::Twist twist;
  twist.linear.x = 0.1;
  twist.angular.z = 1.0;
  FootbotWheels wheels;
  fromMessage(twist, wheels);
  // the left wheel runs on a circle that is smaller by half the track
  EXPECT_NEAR((0.1 - 1.0 * 0.07) / 0.029, wheels.left, 1e-12);
  EXPECT_NEAR((0.1 + 1.0 * 0.07) / 0.029, wheels.right, 1e-12);
  geometry_msgs::Twist back;
  toMessage(wheels, back);
  EXPECT_NEAR(0.1, back.linear.x, 1e-12);
  EXPECT_NEAR(1.0, back.angular.z, 1e-12);
}

TEST(DeviceMessages, ArmsKeepWhatIsNotNamed) {
  HandbotArms arms{{0.1, 0.2, 0.3}, {0.4, 0.5, 0.6}};
  sensor_msgs::JointState message;
  message.name = {"right_elbow", "left_wrist"};
  message.position = {-1.0, 1.0};
  fromMessage(message, arms);
  EXPECT_EQ(-1.0, arms.right.elbow);
  EXPECT_EQ(1.0, arms.left.wrist);
  EXPECT_EQ(0.1, arms.left.shoulder);
  EXPECT_EQ(0.6, arms.right.wrist);
}

TEST(DeviceMessages, BadOnesAreRefusedAndChangeNothing) {
  swarmanoid_msgs::ProximityArray proximity;
  proximity.values.resize(8);
  EXPECT_EQ("found 8 values, expected 24", (refusalOf(proximity, FootbotProximity{})));

  geometry_msgs::Twist twist;
  twist.linear.y = 0.5;
  EXPECT_EQ("found linear.y 0.500000, allowed: 0, this robot cannot do it", (refusalOf(twist, FootbotWheels{1, 2})));
  EXPECT_EQ("", (refusalOf(twist, EyebotVelocity{})));
  twist.linear.z = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ("found a number that is not finite, allowed: finite numbers", (refusalOf(twist, EyebotVelocity{})));

  swarmanoid_msgs::TurretCommand turret;
  turret.mode = 3;
  EXPECT_EQ("found mode 3, allowed: 0 (ANGLE), 1 (SPEED), 2 (PASSIVE)", (refusalOf(turret, FootbotTurret{})));

  swarmanoid_msgs::LedArray leds;
  leds.colors.resize(16);
  EXPECT_EQ("found 16 colours, expected 12", (refusalOf(leds, FootbotLeds{})));
  EXPECT_EQ("", (refusalOf(leds, EyebotLeds{})));

  sensor_msgs::JointState joints;
  joints.name = {"left_elbow", "left_elbo"};
  joints.position = {1.0};
  EXPECT_EQ("found 1 positions, expected 2, one for each name", (refusalOf(joints, HandbotArms{})));
  joints.position = {1.0, 2.0};
  EXPECT_EQ(
      "found joint 'left_elbo', allowed: left_shoulder, left_elbow, left_wrist, right_shoulder, right_elbow, "
      "right_wrist; did you mean 'left_elbow'?",
      (refusalOf(joints, HandbotArms{})));
  EXPECT_EQ("found 2 joints and at least 0 values, expected joint 'turret' with position, velocity and effort",
            (refusalOf(joints, FootbotTurretState{})));
}

TEST(DeviceMessages, TwoWheelsRefuseEachMotionThatTheyCannotCarryOut) {
  geometry_msgs::Twist left, up, roll, pitch;
  left.linear.y = 0.5;
  up.linear.z = 0.5;
  roll.angular.x = 0.5;
  pitch.angular.y = 0.5;
  const std::pair<const char*, geometry_msgs::Twist> motions[] = {
      {"linear.y", left}, {"linear.z", up}, {"angular.x", roll}, {"angular.y", pitch}};
  for (const auto& [name, twist] : motions) {
    const std::string expected = "found " + std::string(name) + " 0.500000, allowed: 0, this robot cannot do it";
    EXPECT_EQ(expected, (refusalOf(twist, FootbotWheels{1, 2})));
    EXPECT_EQ(expected, (refusalOf(twist, DifferentialDrive{0.1, 0.2})));
  }
}

TEST(DeviceTopics, TheFirstIsTheMainOne) {
  EXPECT_EQ("wheels/command", mainTopicOf("footbot_wheels")->name);
  EXPECT_EQ(2U, topicsOf("footbot_wheels").size());
  EXPECT_EQ("geometry_msgs/Twist", topicsOf("footbot_wheels")[1]->message);
  EXPECT_EQ(nullptr, mainTopicOf("footbot_wings"));
}

}  // namespace
}  // namespace swarmanoid

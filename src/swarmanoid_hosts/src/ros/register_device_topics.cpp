// The topics of the suite's devices.
#include "swarmanoid_hosts/ros/device_topic.hpp"

namespace swarmanoid {

constexpr auto kReading = DeviceTopic::Kind::kReading;
constexpr auto kCommand = DeviceTopic::Kind::kCommand;

REGISTER_DEVICE_TOPIC(FootbotProximity, swarmanoid_msgs::ProximityArray, kReading, "proximity", "base_link")
REGISTER_DEVICE_TOPIC(FootbotCamera, swarmanoid_msgs::ColorBlobs, kReading, "camera/blobs", "base_link")
REGISTER_DEVICE_TOPIC(FootbotGripperState, swarmanoid_msgs::GripperState, kReading, "gripper/state", "gripper_tip")
REGISTER_DEVICE_TOPIC(FootbotTurretState, sensor_msgs::JointState, kReading, "turret/state", "base_link")
REGISTER_DEVICE_TOPIC(EyebotCamera, swarmanoid_msgs::ColorBlobs, kReading, "camera/blobs", "base_link")
REGISTER_DEVICE_TOPIC(EyebotMagnetState, swarmanoid_msgs::GripperState, kReading, "magnet/state", "magnet")
REGISTER_DEVICE_TOPIC(HandbotArmsState, sensor_msgs::JointState, kReading, "joint_states", "base_link")
REGISTER_DEVICE_TOPIC(HandbotHandsState, swarmanoid_msgs::HandsState, kReading, "hands/state", "base_link")
REGISTER_DEVICE_TOPIC(HandbotRopeState, swarmanoid_msgs::RopeState, kReading, "rope/state", "rope_launcher")

REGISTER_DEVICE_TOPIC(FootbotWheels, swarmanoid_msgs::WheelsCommand, kCommand, "wheels/command")
REGISTER_DEVICE_TOPIC(FootbotWheels, geometry_msgs::Twist, kCommand, "cmd_vel")
REGISTER_DEVICE_TOPIC(FootbotGripper, swarmanoid_msgs::GripperCommand, kCommand, "gripper/command")
REGISTER_DEVICE_TOPIC(FootbotTurret, swarmanoid_msgs::TurretCommand, kCommand, "turret/command")
REGISTER_DEVICE_TOPIC(FootbotLeds, swarmanoid_msgs::LedArray, kCommand, "leds/command")
REGISTER_DEVICE_TOPIC(EyebotVelocity, geometry_msgs::Twist, kCommand, "cmd_vel")
REGISTER_DEVICE_TOPIC(EyebotLaser, swarmanoid_msgs::LaserCommand, kCommand, "laser/command")
REGISTER_DEVICE_TOPIC(EyebotLeds, swarmanoid_msgs::LedArray, kCommand, "leds/command")
REGISTER_DEVICE_TOPIC(EyebotMagnet, swarmanoid_msgs::GripperCommand, kCommand, "magnet/command")
REGISTER_DEVICE_TOPIC(HandbotArms, sensor_msgs::JointState, kCommand, "arms/command")
REGISTER_DEVICE_TOPIC(HandbotHands, swarmanoid_msgs::HandsCommand, kCommand, "hands/command")
REGISTER_DEVICE_TOPIC(HandbotRope, swarmanoid_msgs::RopeCommand, kCommand, "rope/command")

}  // namespace swarmanoid

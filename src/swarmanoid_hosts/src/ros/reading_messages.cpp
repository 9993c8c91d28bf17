// Sensors as messages, and back.
#include "swarmanoid_hosts/ros/device_messages.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace swarmanoid {
namespace {

/// @throws std::runtime_error if the joint, or one of its three values, is not there
struct Joint {
  double position = 0.0;
  double velocity = 0.0;
  double effort = 0.0;
};

Joint jointOf(const sensor_msgs::JointState& message, const std::string& name) {
  const auto found = std::find(message.name.begin(), message.name.end(), name);
  const auto i = static_cast<std::size_t>(found - message.name.begin());
  const std::size_t least = std::min({message.position.size(), message.velocity.size(), message.effort.size()});
  if (found == message.name.end() || i >= least) {
    throw std::runtime_error("found " + std::to_string(message.name.size()) + " joints and at least " +
                             std::to_string(least) + " values, expected joint '" + name +
                             "' with position, velocity and effort");
  }
  return {message.position[i], message.velocity[i], message.effort[i]};
}

}  // namespace

std_msgs::ColorRGBA toMessage(Color color) {
  std_msgs::ColorRGBA message;
  message.r = static_cast<float>(color.red) / 255.0F;
  message.g = static_cast<float>(color.green) / 255.0F;
  message.b = static_cast<float>(color.blue) / 255.0F;
  message.a = color.isLit() ? 1.0F : 0.0F;
  return message;
}

Color fromMessage(const std_msgs::ColorRGBA& color) {
  if (!(color.a > 0.0F)) {
    return colors::kBlack;
  }
  const auto channel = [](float value) {
    return static_cast<std::uint8_t>(std::lround(255.0F * std::clamp(value, 0.0F, 1.0F)));
  };
  return {channel(color.r), channel(color.g), channel(color.b)};
}

ros::Time toRosTime(Time time) {
  ros::Time result;
  return result.fromNSec(static_cast<std::uint64_t>(time.time_since_epoch().count()));
}

void toMessage(const FootbotProximity& readings, swarmanoid_msgs::ProximityArray& message) {
  constexpr std::uint8_t kInfrared = 1;
  message.radiation_type = kInfrared;
  message.angles.resize(FootbotProximity::kCount);
  for (std::size_t i = 0; i < FootbotProximity::kCount; ++i) {
    message.angles[i] = static_cast<float>(FootbotProximity::angle(i));
  }
  message.values.assign(readings.value.begin(), readings.value.end());
}

void toMessage(const ColorBlobs& readings, swarmanoid_msgs::ColorBlobs& message) {
  message.blobs.resize(readings.blobs.size());
  for (std::size_t i = 0; i < readings.blobs.size(); ++i) {
    message.blobs[i].color = toMessage(readings.blobs[i].color);
    message.blobs[i].bearing = readings.blobs[i].bearing;
    message.blobs[i].distance = readings.blobs[i].distance;
  }
  message.overflowed = readings.overflowed;
}

void toMessage(const FootbotGripperState& readings, swarmanoid_msgs::GripperState& message) {
  message.gripping = readings.gripping;
}

void toMessage(const HandbotArmsState& readings, sensor_msgs::JointState& message) {
  message.name.assign(HandbotArmsState::kNames.begin(), HandbotArmsState::kNames.end());
  message.position.resize(HandbotArmsState::kJoints);
  message.velocity.resize(HandbotArmsState::kJoints);
  message.effort.resize(HandbotArmsState::kJoints);
  for (std::size_t i = 0; i < HandbotArmsState::kJoints; ++i) {
    message.position[i] = readings.joints[i].angle;
    message.velocity[i] = readings.joints[i].speed;
    message.effort[i] = readings.joints[i].effort;
  }
}

void toMessage(const HandbotHandsState& readings, swarmanoid_msgs::HandsState& message) {
  message.left_holding = readings.left.holding;
  message.left_force = readings.left.force;
  message.right_holding = readings.right.holding;
  message.right_force = readings.right.force;
}

void toMessage(const HandbotRopeState& readings, swarmanoid_msgs::RopeState& message) {
  message.attached = readings.attached;
  message.length = readings.length;
  message.tension = readings.tension;
}

void toMessage(const EyebotMagnetState& readings, swarmanoid_msgs::GripperState& message) {
  message.gripping = readings.attached;
}

void toMessage(const FootbotTurretState& readings, sensor_msgs::JointState& message) {
  message.name.assign(1, "turret");
  message.position.assign(1, readings.angle);
  message.velocity.assign(1, readings.speed);
  message.effort.assign(1, readings.torque);
}

void fromMessage(const swarmanoid_msgs::ProximityArray& message, FootbotProximity& readings) {
  if (message.values.size() != FootbotProximity::kCount) {
    throw std::runtime_error("found " + std::to_string(message.values.size()) + " values, expected " +
                             std::to_string(FootbotProximity::kCount));
  }
  std::copy(message.values.begin(), message.values.end(), readings.value.begin());
}

void fromMessage(const swarmanoid_msgs::ColorBlobs& message, ColorBlobs& readings, VariableParts& parts) {
  const std::size_t count = message.blobs.size();
  parts.clear();
  ColorBlob* blobs = parts.room<ColorBlob>(count);
  for (std::size_t i = 0; i < count; ++i) {
    blobs[i] = {fromMessage(message.blobs[i].color), message.blobs[i].bearing, message.blobs[i].distance};
  }
  readings.blobs = Span<const ColorBlob>(blobs, count);
  readings.overflowed = message.overflowed != 0;
}

void fromMessage(const swarmanoid_msgs::GripperState& message, FootbotGripperState& readings) {
  readings.gripping = message.gripping != 0;
}

void fromMessage(const sensor_msgs::JointState& message, HandbotArmsState& readings) {
  for (std::size_t i = 0; i < HandbotArmsState::kJoints; ++i) {
    const Joint joint = jointOf(message, HandbotArmsState::kNames[i]);
    readings.joints[i] = {joint.position, joint.velocity, joint.effort};
  }
}

void fromMessage(const swarmanoid_msgs::HandsState& message, HandbotHandsState& readings) {
  readings.left = {message.left_holding != 0, message.left_force};
  readings.right = {message.right_holding != 0, message.right_force};
}

void fromMessage(const swarmanoid_msgs::RopeState& message, HandbotRopeState& readings) {
  readings = {message.attached != 0, message.length, message.tension};
}

void fromMessage(const swarmanoid_msgs::GripperState& message, EyebotMagnetState& readings) {
  readings.attached = message.gripping != 0;
}

void fromMessage(const sensor_msgs::JointState& message, FootbotTurretState& readings) {
  const Joint joint = jointOf(message, "turret");
  readings = {joint.position, joint.velocity, joint.effort};
}

}  // namespace swarmanoid

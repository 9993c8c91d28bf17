#include "swarmanoid_interface/ros/device_messages.hpp"

#include <algorithm>
#include <cmath>

namespace swarmanoid {

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

void toMessage(Span<const Color> ring, swarmanoid_msgs::LedArray& message) {
  message.colors.resize(ring.size());
  std::transform(ring.begin(), ring.end(), message.colors.begin(), [](Color color) { return toMessage(color); });
}

}  // namespace swarmanoid

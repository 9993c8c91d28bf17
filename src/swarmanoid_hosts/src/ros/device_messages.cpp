#include "swarmanoid_hosts/ros/device_messages.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace swarmanoid {

ros::Time toRosTime(Time time) {
  ros::Time result;
  return result.fromNSec(static_cast<std::uint64_t>(time.time_since_epoch().count()));
}

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

void toMessage(Span<const Color> ring, swarmanoid_msgs::LedArray& message) {
  message.colors.resize(ring.size());
  std::transform(ring.begin(), ring.end(), message.colors.begin(), [](Color color) { return toMessage(color); });
}

void fromMessage(const swarmanoid_msgs::LedArray& message, Span<Color> ring) {
  if (message.colors.size() != ring.size()) {
    throw std::runtime_error("found " + std::to_string(message.colors.size()) + " colours, expected " +
                             std::to_string(ring.size()));
  }
  std::transform(message.colors.begin(), message.colors.end(), ring.begin(),
                 [](const std_msgs::ColorRGBA& color) { return fromMessage(color); });
}

JointValues jointOf(const sensor_msgs::JointState& message, const std::string& name) {
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

void refuseUnlessZero(const char* name, double value) {
  if (value != 0.0) {
    throw std::runtime_error(std::string("found ") + name + " " + std::to_string(value) +
                             ", allowed: 0, this robot cannot do it");
  }
}

void refuseUnlessForWheels(const geometry_msgs::Twist& velocity) {
  refuseUnlessZero("linear.y", velocity.linear.y);
  refuseUnlessZero("linear.z", velocity.linear.z);
  refuseUnlessZero("angular.x", velocity.angular.x);
  refuseUnlessZero("angular.y", velocity.angular.y);
}

}  // namespace swarmanoid

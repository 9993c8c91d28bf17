// Actuators as messages, and back.
#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>

#include "swarmanoid_hosts/ros/device_messages.hpp"
#include "swarmanoid_interface/configuration.hpp"

namespace swarmanoid {
namespace {

/// In the order of HandbotArmsState::kNames.
template <class Arms>
auto anglesOf(Arms& arms) {
  return std::array{&arms.left.shoulder,  &arms.left.elbow,  &arms.left.wrist,
                    &arms.right.shoulder, &arms.right.elbow, &arms.right.wrist};
}

void refuseUnlessZero(const char* name, double value) {
  if (value != 0.0) {
    throw std::runtime_error(std::string("found ") + name + " " + std::to_string(value) +
                             ", allowed: 0, this robot cannot do it");
  }
}

template <std::size_t n>
void fromColors(const std::vector<std_msgs::ColorRGBA>& colors, std::array<Color, n>& ring) {
  if (colors.size() != n) {
    throw std::runtime_error("found " + std::to_string(colors.size()) + " colours, expected " + std::to_string(n));
  }
  std::transform(colors.begin(), colors.end(), ring.begin(),
                 [](const std_msgs::ColorRGBA& color) { return fromMessage(color); });
}

}  // namespace

void toMessage(const FootbotWheels& command, swarmanoid_msgs::WheelsCommand& message) {
  message.left = command.left;
  message.right = command.right;
}

void fromMessage(const swarmanoid_msgs::WheelsCommand& message, FootbotWheels& command) {
  command.setAngularVelocity(message.left, message.right);
}

void toMessage(const FootbotWheels& command, geometry_msgs::Twist& message) {
  message.linear.x = command.speed();
  message.angular.z = command.turnRate();
}

void fromMessage(const geometry_msgs::Twist& message, FootbotWheels& command) {
  refuseUnlessZero("linear.y", message.linear.y);
  refuseUnlessZero("linear.z", message.linear.z);
  refuseUnlessZero("angular.x", message.angular.x);
  refuseUnlessZero("angular.y", message.angular.y);
  command.drive(message.linear.x, message.angular.z);
}

void toMessage(const FootbotGripper& command, swarmanoid_msgs::GripperCommand& message) {
  message.closed = command.closed;
}

void fromMessage(const swarmanoid_msgs::GripperCommand& message, FootbotGripper& command) {
  command.closed = message.closed != 0;
}

void toMessage(const FootbotTurret& command, swarmanoid_msgs::TurretCommand& message) {
  message.mode = static_cast<std::uint8_t>(command.mode);
  message.angle = command.angle;
  message.speed = command.speed;
}

void fromMessage(const swarmanoid_msgs::TurretCommand& message, FootbotTurret& command) {
  if (message.mode > swarmanoid_msgs::TurretCommand::PASSIVE) {
    throw std::runtime_error("found mode " + std::to_string(message.mode) +
                             ", allowed: 0 (ANGLE), 1 (SPEED), 2 (PASSIVE)");
  }
  command = {static_cast<FootbotTurret::Mode>(message.mode), message.angle, message.speed};
}

void toMessage(const EyebotVelocity& command, geometry_msgs::Twist& message) {
  message.linear.x = command.linear.x();
  message.linear.y = command.linear.y();
  message.linear.z = command.linear.z();
  message.angular.z = command.yaw_rate;
}

void fromMessage(const geometry_msgs::Twist& message, EyebotVelocity& command) {
  refuseUnlessZero("angular.x", message.angular.x);
  refuseUnlessZero("angular.y", message.angular.y);
  command.linear = {message.linear.x, message.linear.y, message.linear.z};
  command.yaw_rate = message.angular.z;
}

void toMessage(const EyebotLaser& command, swarmanoid_msgs::LaserCommand& message) {
  message.on = command.on;
  message.pan = command.pan;
  message.tilt = command.tilt;
}

void fromMessage(const swarmanoid_msgs::LaserCommand& message, EyebotLaser& command) {
  command = {message.on != 0, message.pan, message.tilt};
}

void toMessage(const EyebotMagnet& command, swarmanoid_msgs::GripperCommand& message) { message.closed = command.on; }

void fromMessage(const swarmanoid_msgs::GripperCommand& message, EyebotMagnet& command) {
  command.on = message.closed != 0;
}

void toMessage(const HandbotArms& command, sensor_msgs::JointState& message) {
  message.name.assign(HandbotArmsState::kNames.begin(), HandbotArmsState::kNames.end());
  message.position.clear();
  for (const double* angle : anglesOf(command)) {
    message.position.push_back(*angle);
  }
}

void fromMessage(const sensor_msgs::JointState& message, HandbotArms& command) {
  const auto& names = HandbotArmsState::kNames;
  if (message.position.size() != message.name.size()) {
    throw std::runtime_error("found " + std::to_string(message.position.size()) + " positions, expected " +
                             std::to_string(message.name.size()) + ", one for each name");
  }
  for (std::size_t i = 0; i < message.name.size(); ++i) {
    const auto found = std::find(names.begin(), names.end(), message.name[i]);
    if (found == names.end()) {
      const std::vector<std::string> known(names.begin(), names.end());
      throw std::runtime_error("found joint '" + message.name[i] + "', allowed: " + joinNames(known) +
                               didYouMean(message.name[i], known));
    }
    *anglesOf(command)[static_cast<std::size_t>(found - names.begin())] = message.position[i];
  }
}

void toMessage(const HandbotHands& command, swarmanoid_msgs::HandsCommand& message) {
  message.left = command.left;
  message.right = command.right;
}

void fromMessage(const swarmanoid_msgs::HandsCommand& message, HandbotHands& command) {
  command = {message.left != 0, message.right != 0};
}

void toMessage(const HandbotRope& command, swarmanoid_msgs::RopeCommand& message) {
  message.shot = command.shot;
  message.winding_speed = command.winding_speed;
}

void fromMessage(const swarmanoid_msgs::RopeCommand& message, HandbotRope& command) {
  command = {message.shot != 0, message.winding_speed};
}

void toMessage(Span<const Color> ring, swarmanoid_msgs::LedArray& message) {
  message.colors.resize(ring.size());
  std::transform(ring.begin(), ring.end(), message.colors.begin(), [](Color color) { return toMessage(color); });
}

void toMessage(const FootbotLeds& command, swarmanoid_msgs::LedArray& message) {
  toMessage(Span<const Color>(command.ring.data(), command.ring.size()), message);
}

void toMessage(const EyebotLeds& command, swarmanoid_msgs::LedArray& message) {
  toMessage(Span<const Color>(command.ring.data(), command.ring.size()), message);
}

void fromMessage(const swarmanoid_msgs::LedArray& message, FootbotLeds& command) {
  fromColors(message.colors, command.ring);
}

void fromMessage(const swarmanoid_msgs::LedArray& message, EyebotLeds& command) {
  fromColors(message.colors, command.ring);
}

}  // namespace swarmanoid

/// Converts the fields that several devices' messages share. The devices themselves are in devices/.
///
/// Functions that read a message throw std::runtime_error, whose text gives the value found and the allowed values.
#pragma once

#include <geometry_msgs/Twist.h>
#include <sensor_msgs/JointState.h>
#include <std_msgs/ColorRGBA.h>
#include <swarmanoid_msgs/LedArray.h>

#include <string>

#include "swarmanoid_interface/color.hpp"
#include "swarmanoid_interface/span.hpp"
#include "swarmanoid_interface/time.hpp"

namespace swarmanoid {

ros::Time toRosTime(Time time);

/// The alpha value is 1, or 0 for black ("off").
std_msgs::ColorRGBA toMessage(Color color);
/// The inverse; a colour of alpha 0 is black.
Color fromMessage(const std_msgs::ColorRGBA& color);

void toMessage(Span<const Color> ring, swarmanoid_msgs::LedArray& message);
/// @throws std::runtime_error unless the number of colours is that of the ring's LEDs
void fromMessage(const swarmanoid_msgs::LedArray& message, Span<Color> ring);

/// The values of one joint [rad, rad/s, N m].
struct JointValues {
  double position = 0.0;
  double velocity = 0.0;
  double effort = 0.0;
};
/// @throws std::runtime_error if the joint, or one of its three values, is missing
JointValues jointOf(const sensor_msgs::JointState& message, const std::string& name);

/// Refuses a field of a message that is not 0, since the robot cannot carry it out.
void refuseUnlessZero(const char* name, double value);
/// Refuses a velocity that two wheels cannot carry out: all but linear.x and angular.z must be 0.
void refuseUnlessForWheels(const geometry_msgs::Twist& velocity);

}  // namespace swarmanoid

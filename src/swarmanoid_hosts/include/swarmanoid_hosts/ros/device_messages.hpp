/// Devices as messages, both ways: for each device one function from its struct and one back. What a message does not
/// hold stays as it is; stamp and frame_id of the header are the caller's.
///
/// The functions back throw std::runtime_error, which says what was found and what is allowed, for a message that is
/// no such device; the struct may then be partly written.
#pragma once

#include <geometry_msgs/Twist.h>
#include <sensor_msgs/JointState.h>
#include <std_msgs/ColorRGBA.h>
#include <swarmanoid_msgs/ColorBlobs.h>
#include <swarmanoid_msgs/GripperCommand.h>
#include <swarmanoid_msgs/GripperState.h>
#include <swarmanoid_msgs/HandsCommand.h>
#include <swarmanoid_msgs/HandsState.h>
#include <swarmanoid_msgs/LaserCommand.h>
#include <swarmanoid_msgs/LedArray.h>
#include <swarmanoid_msgs/ProximityArray.h>
#include <swarmanoid_msgs/RopeCommand.h>
#include <swarmanoid_msgs/RopeState.h>
#include <swarmanoid_msgs/TurretCommand.h>
#include <swarmanoid_msgs/WheelsCommand.h>

#include "swarmanoid_interface/byte_stream.hpp"
#include "swarmanoid_interface/color.hpp"
#include "swarmanoid_interface/devices/color_blob_camera.hpp"
#include "swarmanoid_interface/devices/eyebot_laser.hpp"
#include "swarmanoid_interface/devices/eyebot_magnet.hpp"
#include "swarmanoid_interface/devices/eyebot_velocity.hpp"
#include "swarmanoid_interface/devices/footbot_gripper.hpp"
#include "swarmanoid_interface/devices/footbot_proximity.hpp"
#include "swarmanoid_interface/devices/footbot_turret.hpp"
#include "swarmanoid_interface/devices/footbot_wheels.hpp"
#include "swarmanoid_interface/devices/handbot_arms.hpp"
#include "swarmanoid_interface/devices/handbot_hands.hpp"
#include "swarmanoid_interface/devices/handbot_rope.hpp"
#include "swarmanoid_interface/devices/leds.hpp"
#include "swarmanoid_interface/span.hpp"
#include "swarmanoid_interface/time.hpp"

namespace swarmanoid {

/// Alpha is 1, or 0 for black ("off").
std_msgs::ColorRGBA toMessage(Color color);
/// The inverse; a colour of alpha 0 is black.
Color fromMessage(const std_msgs::ColorRGBA& color);

ros::Time toRosTime(Time time);

// Sensors.

void toMessage(const FootbotProximity& readings, swarmanoid_msgs::ProximityArray& message);
void toMessage(const ColorBlobs& readings, swarmanoid_msgs::ColorBlobs& message);
void toMessage(const FootbotGripperState& readings, swarmanoid_msgs::GripperState& message);
void toMessage(const HandbotArmsState& readings, sensor_msgs::JointState& message);
void toMessage(const HandbotHandsState& readings, swarmanoid_msgs::HandsState& message);
void toMessage(const HandbotRopeState& readings, swarmanoid_msgs::RopeState& message);
void toMessage(const EyebotMagnetState& readings, swarmanoid_msgs::GripperState& message);
/// One joint, `turret`.
void toMessage(const FootbotTurretState& readings, sensor_msgs::JointState& message);

void fromMessage(const swarmanoid_msgs::ProximityArray& message, FootbotProximity& readings);
/// The blobs are kept in `parts`.
void fromMessage(const swarmanoid_msgs::ColorBlobs& message, ColorBlobs& readings, VariableParts& parts);
void fromMessage(const swarmanoid_msgs::GripperState& message, FootbotGripperState& readings);
/// In any order of joints; others than the arms' are left out, all of the arms' must be there.
void fromMessage(const sensor_msgs::JointState& message, HandbotArmsState& readings);
void fromMessage(const swarmanoid_msgs::HandsState& message, HandbotHandsState& readings);
void fromMessage(const swarmanoid_msgs::RopeState& message, HandbotRopeState& readings);
void fromMessage(const swarmanoid_msgs::GripperState& message, EyebotMagnetState& readings);
void fromMessage(const sensor_msgs::JointState& message, FootbotTurretState& readings);

// Actuators.

void toMessage(const FootbotWheels& command, swarmanoid_msgs::WheelsCommand& message);
/// Speed ahead and turn rate.
void toMessage(const FootbotWheels& command, geometry_msgs::Twist& message);
void toMessage(const FootbotGripper& command, swarmanoid_msgs::GripperCommand& message);
void toMessage(const FootbotTurret& command, swarmanoid_msgs::TurretCommand& message);
void toMessage(const EyebotVelocity& command, geometry_msgs::Twist& message);
void toMessage(const EyebotLaser& command, swarmanoid_msgs::LaserCommand& message);
void toMessage(const EyebotMagnet& command, swarmanoid_msgs::GripperCommand& message);
/// Joints by name, with positions.
void toMessage(const HandbotArms& command, sensor_msgs::JointState& message);
void toMessage(const HandbotHands& command, swarmanoid_msgs::HandsCommand& message);
void toMessage(const HandbotRope& command, swarmanoid_msgs::RopeCommand& message);
void toMessage(const FootbotLeds& command, swarmanoid_msgs::LedArray& message);
void toMessage(const EyebotLeds& command, swarmanoid_msgs::LedArray& message);
void toMessage(Span<const Color> ring, swarmanoid_msgs::LedArray& message);

void fromMessage(const swarmanoid_msgs::WheelsCommand& message, FootbotWheels& command);
/// linear.x and angular.z; the others must be 0, a footbot cannot do them.
void fromMessage(const geometry_msgs::Twist& message, FootbotWheels& command);
void fromMessage(const swarmanoid_msgs::GripperCommand& message, FootbotGripper& command);
void fromMessage(const swarmanoid_msgs::TurretCommand& message, FootbotTurret& command);
/// linear and angular.z; angular.x and y must be 0.
void fromMessage(const geometry_msgs::Twist& message, EyebotVelocity& command);
void fromMessage(const swarmanoid_msgs::LaserCommand& message, EyebotLaser& command);
void fromMessage(const swarmanoid_msgs::GripperCommand& message, EyebotMagnet& command);
/// Joints that it does not name keep their command.
void fromMessage(const sensor_msgs::JointState& message, HandbotArms& command);
void fromMessage(const swarmanoid_msgs::HandsCommand& message, HandbotHands& command);
void fromMessage(const swarmanoid_msgs::RopeCommand& message, HandbotRope& command);
void fromMessage(const swarmanoid_msgs::LedArray& message, FootbotLeds& command);
void fromMessage(const swarmanoid_msgs::LedArray& message, EyebotLeds& command);

}  // namespace swarmanoid

/// Devices as messages: one function a device, from its struct. The frame_id and stamp of the header are the caller's.
#pragma once

#include <sensor_msgs/JointState.h>
#include <std_msgs/ColorRGBA.h>
#include <swarmanoid_msgs/ColorBlobs.h>
#include <swarmanoid_msgs/GripperState.h>
#include <swarmanoid_msgs/HandsState.h>
#include <swarmanoid_msgs/LedArray.h>
#include <swarmanoid_msgs/ProximityArray.h>
#include <swarmanoid_msgs/RopeState.h>

#include "swarmanoid_interface/color.hpp"
#include "swarmanoid_interface/devices/color_blob_camera.hpp"
#include "swarmanoid_interface/devices/eyebot_magnet.hpp"
#include "swarmanoid_interface/devices/footbot_gripper.hpp"
#include "swarmanoid_interface/devices/footbot_proximity.hpp"
#include "swarmanoid_interface/devices/footbot_turret.hpp"
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

void toMessage(const FootbotProximity& readings, swarmanoid_msgs::ProximityArray& message);
void toMessage(const ColorBlobs& readings, swarmanoid_msgs::ColorBlobs& message);
void toMessage(const FootbotGripperState& readings, swarmanoid_msgs::GripperState& message);
void toMessage(const HandbotArmsState& readings, sensor_msgs::JointState& message);
void toMessage(const HandbotHandsState& readings, swarmanoid_msgs::HandsState& message);
void toMessage(const HandbotRopeState& readings, swarmanoid_msgs::RopeState& message);
void toMessage(const EyebotMagnetState& readings, swarmanoid_msgs::GripperState& message);
/// One joint, `turret`.
void toMessage(const FootbotTurretState& readings, sensor_msgs::JointState& message);
void toMessage(Span<const Color> ring, swarmanoid_msgs::LedArray& message);

}  // namespace swarmanoid

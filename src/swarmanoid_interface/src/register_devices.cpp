// The fields of the suite's devices, in the order in which they travel.
#include "swarmanoid_interface/device_type.hpp"
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

namespace swarmanoid {

template <class Stream>
void fields(Stream& stream, Color& color) {
  all(stream, color.red, color.green, color.blue);
}

template <class Stream>
void fields(Stream& stream, ColorBlob& blob) {
  all(stream, blob.color, blob.bearing, blob.distance);
}

/// Both cameras.
template <class Stream>
void fields(Stream& stream, ColorBlobs& camera) {
  all(stream, camera.blobs, camera.overflowed);
}

template <class Stream>
void fields(Stream& stream, EyebotLaser& laser) {
  all(stream, laser.on, laser.pan, laser.tilt);
}

template <class Stream>
void fields(Stream& stream, EyebotMagnet& magnet) {
  all(stream, magnet.on);
}

template <class Stream>
void fields(Stream& stream, EyebotMagnetState& magnet) {
  all(stream, magnet.attached);
}

template <class Stream>
void fields(Stream& stream, EyebotVelocity& velocity) {
  all(stream, velocity.linear.x(), velocity.linear.y(), velocity.linear.z(), velocity.yaw_rate);
}

template <class Stream>
void fields(Stream& stream, FootbotGripper& gripper) {
  all(stream, gripper.closed);
}

template <class Stream>
void fields(Stream& stream, FootbotGripperState& gripper) {
  all(stream, gripper.gripping);
}

template <class Stream>
void fields(Stream& stream, FootbotProximity& proximity) {
  all(stream, proximity.value);
}

template <class Stream>
void fields(Stream& stream, FootbotTurret& turret) {
  all(stream, turret.mode, turret.angle, turret.speed);
}

template <class Stream>
void fields(Stream& stream, FootbotTurretState& turret) {
  all(stream, turret.angle, turret.speed, turret.torque);
}

template <class Stream>
void fields(Stream& stream, FootbotWheels& wheels) {
  all(stream, wheels.left, wheels.right);
}

template <class Stream>
void fields(Stream& stream, ArmAngles& arm) {
  all(stream, arm.shoulder, arm.elbow, arm.wrist);
}

template <class Stream>
void fields(Stream& stream, HandbotArms& arms) {
  all(stream, arms.left, arms.right);
}

template <class Stream>
void fields(Stream& stream, HandbotArmsState::Joint& joint) {
  all(stream, joint.angle, joint.speed, joint.effort);
}

template <class Stream>
void fields(Stream& stream, HandbotArmsState& arms) {
  all(stream, arms.joints);
}

template <class Stream>
void fields(Stream& stream, HandbotHands& hands) {
  all(stream, hands.left, hands.right);
}

template <class Stream>
void fields(Stream& stream, HandbotHandsState::Hand& hand) {
  all(stream, hand.holding, hand.force);
}

template <class Stream>
void fields(Stream& stream, HandbotHandsState& hands) {
  all(stream, hands.left, hands.right);
}

template <class Stream>
void fields(Stream& stream, HandbotRope& rope) {
  all(stream, rope.shot, rope.winding_speed);
}

template <class Stream>
void fields(Stream& stream, HandbotRopeState& rope) {
  all(stream, rope.attached, rope.length, rope.tension);
}

template <class Stream>
void fields(Stream& stream, FootbotLeds& leds) {
  all(stream, leds.ring);
}

template <class Stream>
void fields(Stream& stream, EyebotLeds& leds) {
  all(stream, leds.ring);
}

REGISTER_DEVICE(FootbotCamera)
REGISTER_DEVICE(EyebotCamera)
REGISTER_DEVICE(EyebotLaser)
REGISTER_DEVICE(EyebotMagnet)
REGISTER_DEVICE(EyebotMagnetState)
REGISTER_DEVICE(EyebotVelocity)
REGISTER_DEVICE(FootbotGripper)
REGISTER_DEVICE(FootbotGripperState)
REGISTER_DEVICE(FootbotProximity)
REGISTER_DEVICE(FootbotTurret)
REGISTER_DEVICE(FootbotTurretState)
REGISTER_DEVICE(FootbotWheels)
REGISTER_DEVICE(HandbotArms)
REGISTER_DEVICE(HandbotArmsState)
REGISTER_DEVICE(HandbotHands)
REGISTER_DEVICE(HandbotHandsState)
REGISTER_DEVICE(HandbotRope)
REGISTER_DEVICE(HandbotRopeState)
REGISTER_DEVICE(FootbotLeds)
REGISTER_DEVICE(EyebotLeds)

}  // namespace swarmanoid

/// The state of a mock robot, which its mock devices read and write. They interact only through this state.
///
/// Joints and holders have names, as the mechanisms in a robot's description have: "turret", "gripper". A joint or
/// holder that no device has written yet is at rest.
#pragma once

#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "swarmanoid_interface/devices/radio.hpp"
#include "world.hpp"

namespace swarmanoid::mock {

/// A velocity in the robot's frame.
struct Twist {
  Eigen::Vector3d linear = Eigen::Vector3d::Zero();  ///< [m/s]
  double yaw_rate = 0.0;                             ///< [rad/s]
};

struct Joint {
  double angle = 0.0;  ///< [rad]
  double speed = 0.0;  ///< [rad/s]

  /// Turns by `way`, limited by the speed `fastest`. @param way [rad] @param fastest [rad/s] @param dt [s]
  void turn(double way, double fastest, double dt);
};

/// The state of a gripper, a magnet, a suction cup or a rope.
struct Holder {
  bool is_holding = false;
  double length = 0.0;                ///< of the unwound rope [m]
  double force = 0.0;                 ///< on the held object [N]
  std::optional<std::size_t> beacon;  ///< index of the held object in World::beacons
};

/// A message that the robot sends with one of its devices.
struct Saying {
  std::vector<std::uint8_t> payload;
  RadioAddress to = kEverybody;
};

struct MockState {
  World world;
  Pose pose;
  /// The velocity that the drives command, and after the motion the one that the robot had.
  Twist twist;
  /// True while a device flies the robot to a position; devices that command velocities then have no effect.
  bool flies_to_place = false;
  /// Maximum height of the robot [m].
  double top = std::numeric_limits<double>::infinity();
  /// True while a device holds the robot in its place, so that it does not move.
  bool is_fixed = false;
  std::map<std::string, Joint> joints;
  std::map<std::string, Holder> holders;
  /// Spots of light on the ground, by the device that makes them: cameras see them as they see beacons.
  std::map<std::string, Beacon> spots;
  /// The messages that the robot sends, by the type of the sending device; devices without an entry are silent.
  std::map<std::string, Saying> sayings;

  /// Return the joint or holder of a name, at rest if no device has written it.
  Joint joint(const std::string& name) const;
  Holder holder(const std::string& name) const;

  /// Moves the robot with its velocity: on the ground's plane along an arc, upwards between ground and top.
  void move(double dt);
};

}  // namespace swarmanoid::mock

/// The state of a mock robot: what its mock devices read and write. They know each other by this state only.
///
/// Joints and holders have names, as the mechanisms in a robot's description have: "turret", "gripper". A joint or
/// holder that nobody has written yet is at rest.
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

  /// Turns by `way`, or as far as `fastest` allows. @param way [rad] @param fastest [rad/s] @param dt [s]
  void turn(double way, double fastest, double dt);
};

/// What a gripper, a magnet, a suction cup or a rope holds.
struct Holder {
  bool is_holding = false;
  double length = 0.0;                ///< of a rope that is out [m]
  double force = 0.0;                 ///< on what is held [N]
  std::optional<std::size_t> beacon;  ///< what is held, in the world's list
};

/// A message that the robot sends by one of its devices.
struct Saying {
  std::vector<std::uint8_t> payload;
  RadioAddress to = kEverybody;
};

struct MockState {
  World world;
  Pose pose;
  /// The velocity that the drives command, and after the motion the one that the robot had.
  Twist twist;
  /// Whether a device flies the robot to a place: devices that command velocities leave it alone meanwhile.
  bool flies_to_place = false;
  /// Height over which the robot cannot rise [m].
  double top = std::numeric_limits<double>::infinity();
  /// Whether something holds the robot in its place, so that it does not move.
  bool is_fixed = false;
  std::map<std::string, Joint> joints;
  std::map<std::string, Holder> holders;
  /// Spots of light on the ground, by the device that makes them: cameras see them as they see beacons.
  std::map<std::string, Beacon> spots;
  /// What the robot says, by the type of the device that sends; it is silent by those that are not here.
  std::map<std::string, Saying> sayings;

  /// Return those of a name, at rest if nobody has written it.
  Joint joint(const std::string& name) const;
  Holder holder(const std::string& name) const;

  /// Moves the robot with its velocity: on the ground's plane along an arc, upwards between ground and top.
  void move(double dt);
};

}  // namespace swarmanoid::mock

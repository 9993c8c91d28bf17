/// The surroundings of a mock robot: walls, coloured objects, a white floor with coloured discs and radio tags, a
/// ceiling. They suffice for its sensors to show its motion.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

#include "swarmanoid_interface/color.hpp"
#include "swarmanoid_interface/configuration.hpp"

namespace swarmanoid::mock {

/// The pose of a robot [m, rad]: x ahead of its start, y left of it, z up, yaw counter-clockwise.
struct Pose {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  double yaw = 0.0;

  /// Converts a point of the world to the robot's frame, and back.
  Eigen::Vector3d toRobot(const Eigen::Vector3d& point) const;
  Eigen::Vector3d toWorld(const Eigen::Vector3d& point) const;
};

/// An upright wall of sufficient height, from one point of the ground to another.
struct Wall {
  Eigen::Vector2d from;  ///< in the world [m]
  Eigen::Vector2d to;    ///< in the world [m]
};

/// An object that cameras see, and that shines on light sensors as a lamp of its colour. It may also send messages or
/// answer them, and emit a sound.
struct Beacon {
  static constexpr std::size_t kMostBytes = 10;  ///< of its message: as many as in a message of range and bearing

  std::string name;
  Eigen::Vector3d at;  ///< in the world [m]
  Color color;
  bool can_be_gripped = false;
  std::vector<std::uint8_t> says{};  ///< bytes of the message that it sends in each tick; none: it is silent
  double sound_level = 0.0;          ///< sound pressure level at 1 m [dB re 20 uPa]; 0: no sound
  double sound_frequency = 1000.0;   ///< [Hz]
  bool answers = false;              ///< answers messages of the robot with their bytes, all bits inverted
};

/// A coloured disc on the floor.
struct Disc {
  Eigen::Vector2d at;   ///< its centre, in the world [m]
  double radius = 0.0;  ///< [m]
  Color color;
};

/// A radio tag in the floor.
struct Tag {
  Eigen::Vector2d at;      ///< in the world [m]
  std::uint32_t id = 1;    ///< 1 or more
  std::uint32_t data = 0;  ///< the content of its memory
};

struct World {
  /// Sensors around the body of a robot whose real ones are not known here: evenly spaced around its axis, the first
  /// ahead.
  struct Ring {
    std::size_t sensors = 8;
    double radius = 0.035;  ///< [m]

    /// Direction of a sensor in the robot's frame [rad].
    double angle(std::size_t sensor) const;
  };

  /// Joints of a robot whose real ones are not known here, without stops.
  struct Joints {
    std::size_t count = 1;
    double fastest = 3.0;  ///< [rad/s]

    /// Names of the joints in the robot's state: "joint_0", ...
    static std::string name(std::size_t joint) { return "joint_" + std::to_string(joint); }
  };
  /// Holders of a robot whose real ones are not known here, each with an object within reach.
  struct Holders {
    std::size_t count = 1;
    double rope = 0.0;  ///< length of the rope of each; 0: they have none [m]

    /// Names of the holders in the robot's state: "holder_0", ...
    static std::string name(std::size_t holder) { return "holder_" + std::to_string(holder); }
  };

  /// Wheels of a robot whose real ones are not known here.
  struct Wheels {
    double radius = 0.029;     ///< [m]
    double separation = 0.14;  ///< between them [m]
  };

  std::vector<Wall> walls;
  std::vector<Beacon> beacons;
  std::vector<Disc> discs;  ///< on a white floor; later ones cover earlier ones
  std::vector<Tag> tags;
  double ceiling = 3.0;  ///< height of the ceiling, which is ferromagnetic [m]
  Ring ring;
  Joints joints;
  Holders holders;
  Wheels wheels;
  /// Whether a handbot's left or right hand touches an object when its arm is level.
  bool is_something_left = true;
  bool is_something_right = true;
};

/// Reads the world from values such as these of a parameter file:
///     walls: {front: [1, -1, 1, 1]}                        from x, y to x, y
///     beacons: {prey: {at: [0.5, 0, 0.05], color: yellow, can_be_gripped: true}, nest: {..., says: [1, 255]},
///               partner: {..., answers: true}, horn: {..., sound_level: 70, sound_frequency: 440}}
///     discs: {nest: {at: [0.5, 0], radius: 0.3, color: gray}}
///     tags: {door: {at: [0.5, 0], id: 7, data: 1234}}
///     ceiling: 3
///     hands: {left: true, right: false}                    whether a level arm touches an object
///     ring: {sensors: 8, radius: 0.035}                    of a `proximity`, `light`, `ground` or `microphones`
///     joints: {count: 2, fastest: 3}                       of `joints` and `joint_states`
///     holders: {count: 1, rope: 2}                         of `holders` and `holder_states`
///     wheels: {radius: 0.02, separation: 0.05}             of `wheel_encoders` and `odometry`
/// @throws ConfigError
World readWorld(const Configuration& values);

/// Returns the distance from a point along a direction of the ground to the nearest wall. @return infinity if there is
/// none [m]
double distanceToWall(const World& world, const Eigen::Vector2d& from, double direction);

/// Returns the distance from a sensor that looks outwards from a ring around the robot's axis to the nearest wall.
/// @return infinity if there is none; less than 0 for a wall inside of the ring [m]
/// @param angle of the sensor in the robot's frame [rad] @param radius of the ring [m]
double wayToWall(const World& world, const Pose& pose, double angle, double radius);

/// Returns the reading of the walls by an infrared sensor that looks outwards from a ring around the robot's axis, by
/// Proximity::response: 0 with nothing in range, 1 at contact. @param angle of the sensor in the robot's frame [rad]
/// @param radius of the ring [m]
float closenessOfWall(const World& world, const Pose& pose, double angle, double radius);

/// Returns the colour of the floor under a sensor at the height of the robot's contact with the ground: black if the
/// robot is higher above the floor than the usual range of ground sensors.
/// @param place of the sensor in the robot's frame [m]
Color floorColorUnder(const World& world, const Pose& pose, const Eigen::Vector2d& place);

/// Returns the reading of that colour by a ground sensor, by Ground::reflection.
/// @param place of the spot in the robot's frame [m]
float reflectionUnder(const World& world, const Pose& pose, const Eigen::Vector2d& place);

}  // namespace swarmanoid::mock

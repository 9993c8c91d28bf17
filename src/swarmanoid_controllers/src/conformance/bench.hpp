/// What all checks share: the robot with its devices, what is known of the surroundings, and judging.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "swarmanoid_interface/controller.hpp"
#include "swarmanoid_interface/devices/color_blob_camera.hpp"

namespace swarmanoid::conformance {

/// The place where the robot is tested, as it stands at the start. A distance of 0: there is none.
struct Surroundings {
  Color beacon_color;            ///< of what is straight ahead
  double beacon_distance = 0.0;  ///< [m]
  Color prey_color;              ///< of what is to the left: for footbots a prey that can be gripped
  double prey_distance = 0.0;    ///< [m]
  double prey_bearing = 0.0;     ///< [rad]
  double wall_distance = 0.0;    ///< from the robot's middle to a wall on its right, along the robot [m]
  double laser_height = 0.0;     ///< of an eyebot's laser pointer above the ground; 0: not known [m]
  bool has_ceiling = false;      ///< a ferromagnetic one, above
  bool has_board =
      false;  ///< upright, which the left hand meets when its arm is stretched ahead, and the right one does not
  bool is_free_upwards = false;   ///< the robot can move up and down
  std::size_t observed_leds = 0;  ///< of an observed robot, in its ring; 0: nobody is observed
  double observed_radius = 0.0;   ///< of that ring [m]
  double observer_bearing = 0.0;  ///< where the observed robot has the observer [rad]
};

class Bench {
 public:
  /// @throws ConfigError
  Bench(Robot& robot, const Configuration& parameters);

  Robot& robot() { return robot_; }
  const Surroundings& surroundings() const { return surroundings_; }
  bool isObserver() const { return is_observer_; }
  /// Seconds after a motion until what it did can be seen.
  double settlingTime() const { return settling_time_; }
  /// How far a measured value may be from the expected one, as a part of it.
  double tolerance() const { return tolerance_; }

  bool isListed(const std::string& device) const;
  /// Null if the configuration does not list it.
  template <class Device>
  const Device* sensor() const {
    return robot_.hasSensor(Device::kType) ? &robot_.sensor<Device>() : nullptr;
  }
  template <class Device>
  Device* actuator() const {
    return robot_.hasActuator(Device::kType) ? &robot_.actuator<Device>() : nullptr;
  }

  /// The middle of all that is about of that colour, as the robot's camera sees it, in its frame [m].
  std::optional<Eigen::Vector2d> see(Color color) const;
  /// The same; nothing in sight is a failure, and the origin.
  Eigen::Vector2d find(Color color, const std::string& name);

  /// Stops all that moves the robot.
  void rest();

  /// Judging. What is found goes into the log, with the name of the check; what is wrong makes it fail.
  void startCheck(const std::string& name);
  void expectNear(const std::string& what, double found, double expected, double allowed, const char* unit);
  /// The allowed difference is the tolerance of `expected`, and at least `least`.
  void expectAbout(const std::string& what, double found, double expected, double least, const char* unit);
  void expectAngle(const std::string& what, double found, double expected, double allowed);
  void expectTrue(const std::string& what, bool is_true);
  void fail(const std::string& why);
  /// "" if nothing is wrong with the check so far
  const std::string& failure() const { return failure_; }

 private:
  void readSurroundings(const Configuration& parameters);
  void judge(const std::string& text, bool is_good);

  Robot& robot_;
  Surroundings surroundings_;
  const ColorBlobs* camera_ = nullptr;
  bool is_observer_ = false;
  double settling_time_ = 0.5;
  double tolerance_ = 0.15;
  std::string check_;
  std::string failure_;
};

double bearingOf(const Eigen::Vector2d& place);
std::string withUnit(double value, const char* unit);

}  // namespace swarmanoid::conformance

/// Shared by all checks: the robot with its devices, the known data of the surroundings, and the verdict.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "surroundings.hpp"
#include "swarmanoid_interface/controller.hpp"
#include "swarmanoid_interface/devices/color_blob_camera.hpp"

namespace swarmanoid::conformance {

class Bench {
 public:
  /// @throws ConfigError
  Bench(Robot& robot, const Configuration& parameters);

  Robot& robot() { return robot_; }
  const Surroundings& surroundings() const { return surroundings_; }
  bool isObserver() const { return is_observer_; }
  /// Returns the time after a motion until its effect can be measured [s].
  double settlingTime() const { return surroundings_.settling_time; }
  /// Returns the allowed relative difference between a measured value and the expected one.
  double tolerance() const { return tolerance_; }

  const std::string& robotType() const { return robot_.type(); }
  /// Returns the type of the camera that the robot uses; "" if its configuration lists none.
  const std::string& cameraDevice() const { return camera_device_; }
  bool isListed(const std::string& device) const;
  /// Returns null if the configuration does not list the device.
  template <class Device>
  const Device* sensor() const {
    return robot_.hasSensor(Device::kType) ? &robot_.sensor<Device>() : nullptr;
  }
  template <class Device>
  Device* actuator() const {
    return robot_.hasActuator(Device::kType) ? &robot_.actuator<Device>() : nullptr;
  }

  /// Returns the positions of all blobs with about that colour in the readings of the robot's camera, in its frame [m].
  std::vector<Eigen::Vector2d> placesOf(Color color) const;
  /// Returns the mean of placesOf.
  std::optional<Eigen::Vector2d> see(Color color) const;
  /// The same as `see`, but without a blob in sight the check fails, and the origin is returned.
  Eigen::Vector2d find(Color color, const std::string& name);
  /// Returns the readings of the camera. @pre the robot has a camera
  const ColorBlobs& seen() const { return *camera_; }

  /// Commands rest to all actuators that move the robot.
  void rest();

  /// Starts the verdict of a check. Findings are logged under the name of the check; a wrong value makes it fail.
  void startCheck(const std::string& name);
  void expectNear(const std::string& what, double found, double expected, double allowed, const char* unit);
  /// The allowed difference is `tolerance` times `expected`, and at least `least`.
  void expectAbout(const std::string& what, double found, double expected, double least, const char* unit);
  void expectAngle(const std::string& what, double found, double expected, double allowed);
  void expectTrue(const std::string& what, bool is_true);
  void fail(const std::string& why);
  /// Returns the failures of the check so far, "" without any.
  const std::string& failure() const { return failure_; }

 private:
  void readParameters(const Configuration& parameters);
  void judge(const std::string& text, bool is_good);

  Robot& robot_;
  Surroundings surroundings_;
  const ColorBlobs* camera_ = nullptr;
  std::string camera_device_;
  bool is_observer_ = false;
  double tolerance_ = 0.15;
  std::string check_;
  std::string failure_;
};

/// Returns whether two colours look alike: real sensors do not report exactly the colour of the object.
bool isAbout(Color a, Color b);
/// Returns the mean direction of all blobs with about that colour [rad], as below; nothing if none is in sight.
std::optional<double> bearingOf(const ColorBlobs& seen, Color color);
/// Returns whether all blobs with about that colour are below the camera's horizon, as objects on the ground are.
bool isBelowHorizon(const ColorBlobs& seen, Color color);
/// Returns the direction of a place in the robot's frame [rad], counter-clockwise from ahead, in [-pi, pi].
double bearingOf(const Eigen::Vector2d& place);
std::string withUnit(double value, const char* unit);

}  // namespace swarmanoid::conformance

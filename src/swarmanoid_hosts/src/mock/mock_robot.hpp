/// Simulates robots by simple kinematics behind the devices of a real one, without ROS. They serve to try controllers
/// and hosts, not for experiments: no body has mass, no bodies collide, readings have no noise.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "swarmanoid_interface/devices/color_blob_camera.hpp"
#include "swarmanoid_interface/robot.hpp"
#include "swarmanoid_interface/safe_stop.hpp"
#include "world.hpp"

namespace swarmanoid::mock {

class MockRobot {
 public:
  struct Sensor {
    std::string device;
    const void* reading;
  };
  struct Actuator {
    std::string device;
    void* command;
  };
  /// A velocity in the robot's frame.
  struct Twist {
    Eigen::Vector3d linear = Eigen::Vector3d::Zero();  ///< [m/s]
    double yaw_rate = 0.0;                             ///< [rad/s]
  };

  virtual ~MockRobot() = default;
  MockRobot(const MockRobot&) = delete;
  MockRobot& operator=(const MockRobot&) = delete;

  /// Carries out the commands for `dt` seconds, then reads the sensors.
  void advance(double dt) {
    move(dt);
    sense();
  }

  const std::vector<Sensor>& sensors() const { return sensors_; }
  const std::vector<Actuator>& actuators() const { return actuators_; }
  const Pose& pose() const { return pose_; }
  const Twist& twist() const { return twist_; }
  const World& world() const { return world_; }

 protected:
  MockRobot(World world, Pose start) : world_(std::move(world)), pose_(std::move(start)) {}

  virtual void move(double dt) = 0;
  virtual void sense() = 0;

  template <class Device>
  void provideSensor(const Device& reading) {
    sensors_.push_back({Device::kType, &reading});
  }
  template <class Device>
  void provideActuator(Device& command) {
    actuators_.push_back({Device::kType, &command});
  }

  World world_;
  Pose pose_;
  Twist twist_;

 private:
  std::vector<Sensor> sensors_;
  std::vector<Actuator> actuators_;
};

/// Reads the robot's world and its start from `values`: `start: [x, y, z]`, `start_yaw` [degrees], and the values of
/// readWorld.
/// @param type footbot, eyebot, handbot @throws ConfigError
std::unique_ptr<MockRobot> makeMockRobot(const std::string& type, const Configuration& values);

std::unique_ptr<MockRobot> makeMockFootbot(World world, Pose start);
std::unique_ptr<MockRobot> makeMockEyebot(World world, Pose start);
std::unique_ptr<MockRobot> makeMockHandbot(World world, Pose start);

/// Returns the beacon as a camera at the robot reports it.
ColorBlob blobOf(const Beacon& beacon, const Pose& pose);

/// Does what a driver does when commands are missing: after `timeout` an actuator that had commands gets those of its
/// safe stop, until a command comes again.
class CommandWatchdog {
 public:
  /// @param timeout [s]
  CommandWatchdog(const MockRobot& robot, double timeout);

  void commanded(std::size_t actuator) { silence_[actuator] = 0.0; }
  /// Is called before the robot moves. @param dt [s]
  void advance(double dt);
  /// Returns whether no command has come for longer than `timeout`, so that the actuator is being stopped.
  bool hasExpired(std::size_t actuator) const { return silence_[actuator] > timeout_; }

 private:
  static constexpr double kNever = -1.0;  // the actuator has had no command yet

  const MockRobot& mock_;
  Robot robot_;
  double timeout_;
  std::vector<double> silence_;  // [s]
};

}  // namespace swarmanoid::mock

/// Base class of actuators that turn two wheels: their speeds are limited to the motors' maximum.
#pragma once

#include <algorithm>
#include <string>

#include "common/mechanisms.hpp"
#include "swarmanoid_space/actuator.hpp"

namespace swarmanoid::devices {

/// Angular velocities [rad/s].
struct WheelSpeeds {
  double left = 0.0;
  double right = 0.0;
};

template <class Device>
struct WheelDriveInstance : BasicActuatorInstance<Device> {
  const EntityModel::Wheels* wheels = nullptr;
  WheelTurns turns_before;  // for slipping_wheels.hpp: before the engine moves the robot, rad

  void archive(StateArchive& state) { state(turns_before); }
};

/// `Drive` derives from this, and converts between its command and the speeds of two wheels:
/// `static WheelSpeeds toSpeeds(const Device&, const EntityModel::Wheels&)` and
/// `static void fromSpeeds(const WheelSpeeds&, const EntityModel::Wheels&, Device&)`.
template <class Drive, class Device>
class WheelDriveActuator : public ActuatorOf<Device, WheelDriveInstance<Device>> {
 public:
  using Instance = WheelDriveInstance<Device>;

  void configure(const Configuration& /*parameters*/) override {}

 protected:
  WheelDriveActuator() { this->is_by_robot_ = true; }

  static PluginDescription describeDrive(const std::string& summary) {
    PluginDescription description;
    description.label = Device::kType;
    description.implementation = "default";
    description.is_default = true;
    description.mechanisms = {wheels()};
    description.summary = summary;
    return description;
  }

  void prepareInstance(const Space& space, Instance& instance) override {
    const EntityModel& model = *space.entities.model[instance.row];
    if (!model.wheels) {
      refuseWithout(Device::kType, model, "wheels");
    }
    instance.wheels = &*model.wheels;
  }

  void limit(const Space& /*space*/, Instance& instance) override {
    WheelSpeeds speeds = Drive::toSpeeds(*instance.actuation, *instance.wheels);
    const double fastest = instance.wheels->max_speed;
    speeds.left = std::clamp(speeds.left, -fastest, fastest);
    speeds.right = std::clamp(speeds.right, -fastest, fastest);
    Drive::fromSpeeds(speeds, *instance.wheels, *instance.actuation);
  }

  void apply(const Space& /*space*/, const ActuateAccess& access, Instance& instance) override {
    const WheelSpeeds speeds = Drive::toSpeeds(*instance.actuation, *instance.wheels);
    access.wheels[instance.row] = {true, speeds.left, speeds.right};
  }
};

/// A device with a field for each wheel, `left` and `right` [rad/s].
template <class Drive, class Device>
class WheelSpeedActuator : public WheelDriveActuator<Drive, Device> {
 public:
  static WheelSpeeds toSpeeds(const Device& command, const EntityModel::Wheels& /*wheels*/) {
    return {command.left, command.right};
  }
  static void fromSpeeds(const WheelSpeeds& speeds, const EntityModel::Wheels& /*wheels*/, Device& command) {
    command.left = speeds.left;
    command.right = speeds.right;
  }
};

}  // namespace swarmanoid::devices

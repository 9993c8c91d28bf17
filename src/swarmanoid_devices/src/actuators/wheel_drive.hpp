/// What all actuators that turn two wheels have in common: the speeds are limited by the motors.
#pragma once

#include <algorithm>
#include <string>

#include "mechanisms.hpp"
#include "swarmanoid_space/actuator.hpp"

namespace swarmanoid::devices {

template <class Device>
struct WheelDriveInstance : BasicActuatorInstance<Device> {
  EntityModel::Wheels wheels;
};

/// `Device` has `left` and `right` [rad/s], or the derived class says how it becomes these and how they become it.
template <class Device>
class WheelDriveActuator : public ActuatorOf<Device, WheelDriveInstance<Device>> {
 public:
  using Instance = WheelDriveInstance<Device>;

  void configure(const Configuration& /*parameters*/) override {}

 protected:
  /// Angular velocities [rad/s].
  struct Speeds {
    double left = 0.0;
    double right = 0.0;
  };

  static PluginDescription describeDrive(const std::string& summary) {
    PluginDescription description;
    description.label = Device::kType;
    description.implementation = "default";
    description.is_default = true;
    description.mechanisms = {wheels()};
    description.summary = summary;
    return description;
  }

  virtual Speeds toSpeeds(const Device& command, const EntityModel::Wheels& wheels) const = 0;
  virtual void fromSpeeds(const Speeds& speeds, const EntityModel::Wheels& wheels, Device& command) const = 0;

  void prepareInstance(const Space& space, Instance& instance) override {
    const EntityModel& model = *space.entities.model[instance.row];
    if (!model.wheels) {
      refuseWithout(Device::kType, model, "wheels");
    }
    instance.wheels = *model.wheels;
  }

  void limit(const Space& /*space*/, Instance& instance) override {
    Speeds speeds = toSpeeds(*instance.actuation, instance.wheels);
    const double fastest = instance.wheels.max_speed;
    speeds.left = std::clamp(speeds.left, -fastest, fastest);
    speeds.right = std::clamp(speeds.right, -fastest, fastest);
    fromSpeeds(speeds, instance.wheels, *instance.actuation);
  }

  void apply(Space& space, Instance& instance) override {
    const Speeds speeds = toSpeeds(*instance.actuation, instance.wheels);
    space.wheels[instance.row] = {true, speeds.left, speeds.right};
  }
};

/// A device with a field for each wheel.
template <class Device>
class WheelSpeedActuator : public WheelDriveActuator<Device> {
 protected:
  using Speeds = typename WheelDriveActuator<Device>::Speeds;

  Speeds toSpeeds(const Device& command, const EntityModel::Wheels& /*wheels*/) const override {
    return {command.left, command.right};
  }
  void fromSpeeds(const Speeds& speeds, const EntityModel::Wheels& /*wheels*/, Device& command) const override {
    command.left = speeds.left;
    command.right = speeds.right;
  }
};

}  // namespace swarmanoid::devices

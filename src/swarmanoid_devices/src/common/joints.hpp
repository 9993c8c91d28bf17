/// Base classes of devices that use joints of a robot (EntityModel::Joint): turrets, arms. The indices of the joints in
/// the model are looked up once, when a robot is added. Commanded angles are limited to the joint's stops, and speeds
/// to the motor's maximum.
///
/// To add an actuator, write its struct and a class such as
///
///     class MyNeckActuator final : public JointActuator<MyNeckActuator, MyNeck> {
///      public:
///       static constexpr std::array<const char*, 1> kJoints{"neck"};
///       static PluginDescription describe() { ...; description.mechanisms = joints(kJoints); ... }
///       static JointTarget targetOf(MyNeck& neck, std::size_t /*which*/) {
///         return {JointCommand::Mode::kAngle, &neck.angle};
///       }
///     };
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>

#include "mechanisms.hpp"
#include "swarmanoid_space/actuator.hpp"
#include "swarmanoid_space/sensor.hpp"

namespace swarmanoid::devices {

// Names in the model of the joints that both an actuator and a sensor use; those of arms are in the header of their
// device.
inline constexpr std::array<const char*, 1> kTurretJoint{"turret"};

/// An instance with the indices of `count` joints in the model; -1 for missing ones.
template <class Instance, std::size_t count>
struct WithJoints : Instance {
  std::shared_ptr<const EntityModel> model;
  std::array<int, count> joints{};

  /// For snapshots: the indices follow from the model.
  void archive(StateArchive& state) {
    if constexpr (StateArchive::kIsDefinedBy<Instance>) {
      Instance::archive(state);
    }
  }
};

template <std::size_t count>
std::array<int, count> jointsOf(const EntityModel& model, const std::array<const char*, count>& names) {
  std::array<int, count> joints{};
  for (std::size_t i = 0; i < count; ++i) {
    joints[i] = model.findJoint(names[i]);
  }
  return joints;
}

/// Command of an actuation for one joint.
struct JointTarget {
  JointCommand::Mode mode = JointCommand::Mode::kPassive;
  double* value = nullptr;  ///< the commanded angle [rad] or speed [rad/s] in the actuation; null: none
};

/// @param motor has `mode`, one of kAngle, kSpeed and kPassive, and `angle` and `speed`
template <class Motor>
JointTarget targetOfMotor(Motor& motor) {
  using Mode = decltype(motor.mode);
  switch (motor.mode) {
    case Mode::kAngle:
      return {JointCommand::Mode::kAngle, &motor.angle};
    case Mode::kSpeed:
      return {JointCommand::Mode::kSpeed, &motor.speed};
    default:
      return {};
  }
}

/// Limits a command to the range of the joint.
inline void limitToJoint(const EntityModel::Joint& joint, const JointTarget& target) {
  if (target.mode == JointCommand::Mode::kAngle) {
    *target.value = std::clamp(*target.value, joint.lower, joint.upper);
  } else if (target.mode == JointCommand::Mode::kSpeed) {
    *target.value = std::clamp(*target.value, -joint.max_speed, joint.max_speed);
  }
}

/// `Derived` has `static constexpr std::array<const char*, count> kJoints`, the names of its joints, or its own
/// `indicesIn`, and `static JointTarget targetOf(Device&, std::size_t which)`, the command of an actuation for each
/// joint.
template <class Derived, class Device, std::size_t count = 1>
class JointActuator : public ActuatorOf<Device, WithJoints<BasicActuatorInstance<Device>, count>> {
 public:
  using Instance = WithJoints<BasicActuatorInstance<Device>, count>;

  static std::array<int, count> indicesIn(const EntityModel& model) { return jointsOf(model, Derived::kJoints); }

  void configure(const Configuration&) override {}

 protected:
  void prepareInstance(const Space& space, Instance& instance) override {
    instance.model = space.entities.model[instance.row];
    instance.joints = Derived::indicesIn(*instance.model);
  }

  void limit(const Space& /*space*/, Instance& instance) override {
    visitTargets(instance, [&](std::size_t joint, const JointTarget& target) {
      limitToJoint(instance.model->joints[joint], target);
    });
  }

  void apply(const Space& /*space*/, const ActuateAccess& access, Instance& instance) override {
    const Span<JointCommand> commands = access.joint_commands[instance.row];
    visitTargets(instance, [&](std::size_t joint, const JointTarget& target) {
      commands[joint] = {target.mode, target.value == nullptr ? 0.0 : *target.value};
    });
  }

 private:
  /// Calls visit(index in the model, target) for the joints that the robot has.
  template <class Visit>
  static void visitTargets(Instance& instance, Visit visit) {
    for (std::size_t which = 0; which < count; ++which) {
      if (const int joint = instance.joints[which]; joint >= 0) {
        visit(static_cast<std::size_t>(joint), Derived::targetOf(*instance.actuation, which));
      }
    }
  }
};

/// As JointActuator, for sensors. `Derived` has `kJoints` or `indicesIn`, and `static void read(Instance&, std::size_t
/// which, const JointState&)`, which writes the readings of a joint. The readings of joints that the robot lacks keep
/// their default values.
template <class Derived, class Device, std::size_t count = 1, class InstanceWithout = BasicSensorInstance<Device>>
class JointSensor : public SensorOf<Device, WithJoints<InstanceWithout, count>> {
 public:
  using Instance = WithJoints<InstanceWithout, count>;

  static std::array<int, count> indicesIn(const EntityModel& model) { return jointsOf(model, Derived::kJoints); }

  void configure(const Configuration&) override {}

  void sense(const Space& space, std::size_t first, std::size_t last) override {
    for (std::size_t k = first; k < last; ++k) {
      Instance& instance = this->instances_[k];
      const Span<const JointState> states = space.joints[instance.row];
      for (std::size_t which = 0; which < count; ++which) {
        if (const int joint = instance.joints[which]; joint >= 0) {
          Derived::read(instance, which, states[static_cast<std::size_t>(joint)]);
        }
      }
    }
  }

 protected:
  void prepareInstance(const Space& space, Instance& instance) override {
    instance.model = space.entities.model[instance.row];
    instance.joints = Derived::indicesIn(*instance.model);
  }
};

}  // namespace swarmanoid::devices

/// The base classes of simulated actuators. One object serves all robots of one controller configuration: it takes
/// their commands, checks, limits and disturbs them, and leaves the actuation, which engines and other parts of the
/// tick read.
///
/// Phases   configure, add, remove, stop: between phases. actuate: the phase of this name. afterMove: in `connect`.
/// Noise    drawn from the instance's own stream.
///
/// To add an actuator: write its struct in an interface header, derive from ActuatorOf<Struct>, end with
/// REGISTER_ACTUATOR. Beside the struct stands its descriptor (swarmanoid_interface/device_type.hpp), for the check of
/// numbers and the safe stop; the struct's initial value means "do nothing".
#pragma once

#include <algorithm>
#include <vector>

#include "swarmanoid_interface/configuration.hpp"
#include "swarmanoid_interface/device_type.hpp"
#include "swarmanoid_interface/random.hpp"
#include "swarmanoid_interface/registry.hpp"
#include "swarmanoid_interface/safe_stop.hpp"
#include "swarmanoid_space/space.hpp"

namespace swarmanoid {

class Actuator {
 public:
  virtual ~Actuator() = default;

  /// @throws ConfigError
  virtual void configure(const Configuration& parameters) = 0;

  /// Adds the instance of a robot. @return where it writes its command, for as long as it lives
  virtual void* add(Space& space, Row row) = 0;
  virtual void remove(Space& space, Row row) = 0;

  /// Commands to actuation. Rows whose command holds a number that is not finite are added to `faulty`; their
  /// actuation stays what it was.
  virtual void actuate(Space& space, std::vector<Row>& faulty) = 0;
  /// After the engines have moved: what depends on the new poses, such as where a laser beam ends.
  virtual void afterMove(Space&) {}
  /// The robot's command becomes that of its safe stop, and is carried out at once. Starts from the last command that
  /// is sound. @return whether the stop is over: the command stays now
  virtual bool stop(Space& space, Row row, const SafeStopMoment& moment) = 0;

  const char* type() const { return type_; }

 protected:
  explicit Actuator(const char* type) : type_(type) {}

 private:
  const char* type_;
};

template <class Device>
struct BasicActuatorInstance {
  Row row = kNoRow;
  EntityNumber number = kNoEntity;
  Device* command = nullptr;
  Device* actuation = nullptr;
  RandomStream random;
};

template <class Device, class Instance = BasicActuatorInstance<Device>>
class ActuatorOf : public Actuator {
  static_assert(kHasFields<Device>,
                "beside the device's struct stand its fields: swarmanoid_interface/device_type.hpp");

 public:
  void* add(Space& space, Row row) override {
    Instance instance;
    instance.row = row;
    instance.number = space.entities.number[static_cast<std::size_t>(row)];
    instance.command = &space.commands.template bank<Device>().add(row);
    instance.actuation = &space.actuation.template bank<Device>().add(row);
    instance.random = RandomStream(space.seed, space.entities.name[static_cast<std::size_t>(row)], Device::kType);
    prepareInstance(space, instance);
    Device* command = instance.command;
    instances_.push_back(std::move(instance));
    return command;
  }

  void remove(Space& space, Row row) override {
    space.commands.template bank<Device>().remove(row);
    space.actuation.template bank<Device>().remove(row);
    instances_.erase(std::remove_if(instances_.begin(), instances_.end(),
                                    [&](const Instance& instance) { return instance.row == row; }),
                     instances_.end());
  }

  void actuate(Space& space, std::vector<Row>& faulty) override {
    for (Instance& instance : instances_) {
      if (isFinite(*instance.command)) {
        *instance.actuation = *instance.command;
        limit(space, instance);
      } else {
        faulty.push_back(instance.row);
      }
      apply(space, instance);
    }
  }

  bool stop(Space& space, Row row, const SafeStopMoment& moment) override {
    bool is_over = true;
    for (Instance& instance : instances_) {
      if (instance.row == row) {
        if (!isFinite(*instance.command)) {
          *instance.command = *instance.actuation;
        }
        is_over = detail::stop(*instance.command, moment);
        detail::stop(*instance.actuation, moment);
        apply(space, instance);
      }
    }
    return is_over;
  }

 protected:
  ActuatorOf() : Actuator(Device::kType) {}

  /// Last chance to prepare a new instance, such as from the entity's model.
  virtual void prepareInstance(const Space&, Instance&) {}
  /// Limits and noise: changes instance.actuation, which starts as the command.
  virtual void limit(const Space&, Instance&) {}
  /// Carries an actuation out that needs no engine, such as the colour of LEDs.
  virtual void apply(Space&, Instance&) {}

  std::vector<Instance> instances_;
};

}  // namespace swarmanoid

/// At the end of an actuator's source. `Class` has a static function `PluginDescription describe()`.
#define REGISTER_ACTUATOR(Class)                                                                \
  namespace {                                                                                   \
  const ::swarmanoid::PluginRegistration<::swarmanoid::Actuator, Class> SWARMANOID_CONCATENATE( \
      registration_, __COUNTER__)(::swarmanoid::PluginKind::kActuator, Class::describe());      \
  }

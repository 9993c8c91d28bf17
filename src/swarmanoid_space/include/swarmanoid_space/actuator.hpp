/// The base classes of simulated actuators. One object serves all robots of one controller configuration: it reads
/// their commands, checks, limits and disturbs them, and passes the resulting actuation to the robots' mechanisms,
/// which engines read.
///
/// Phases   configure, add, remove, setFaults, archive, stop: between phases. actuate: the phase of this name.
///          afterMove: in `connect`. draw: in `show` or between ticks, if a viewer is active.
/// Noise    drawn from the instance's own stream.
/// Errors   errors of <error> elements act on the actuation after the check and before `limit`. addErrorAlias makes a
///          parameter of the actuator mean such an error. The alias draws from a stream of the same name as the
///          instance's own stream, so both give the same numbers: an actuator that draws random numbers itself should
///          have no aliases that draw. Faults of single robots (setFaults) act after these errors and before `limit`.
///
/// To add an actuator: write its struct in an interface header, derive from ActuatorOf<Struct>, end with
/// REGISTER_ACTUATOR. The struct's descriptor (swarmanoid_interface/device_type.hpp) stands beside it; the finiteness
/// check and the safe stop use it. The initial value of the struct means "do nothing".
#pragma once

#include <algorithm>
#include <memory>
#include <mutex>
#include <vector>

#include "swarmanoid_interface/configuration.hpp"
#include "swarmanoid_interface/device_type.hpp"
#include "swarmanoid_interface/random.hpp"
#include "swarmanoid_interface/registry.hpp"
#include "swarmanoid_interface/safe_stop.hpp"
#include "swarmanoid_interface/state_archive.hpp"
#include "swarmanoid_space/access.hpp"
#include "swarmanoid_space/archive_device.hpp"
#include "swarmanoid_space/device_description.hpp"
#include "swarmanoid_space/device_drawing.hpp"
#include "swarmanoid_space/error_models/device_errors.hpp"
#include "swarmanoid_space/error_models/device_fault.hpp"
#include "swarmanoid_space/parallel.hpp"
#include "swarmanoid_space/space.hpp"

namespace swarmanoid {

class Actuator {
 public:
  using DeviceStruct = void;  ///< defined by ActuatorOf

  virtual ~Actuator() = default;

  /// @throws ConfigError
  virtual void configure(const Configuration& parameters) = 0;

  /// Called after `configure`. @throws ConfigError if the errors do not suit the device
  virtual void takeErrors(const std::vector<ErrorModelDescription>& errors) = 0;

  /// Adds the instance of a robot. @return its command struct, valid as long as the robot lives
  virtual void* add(Space& space, Row row) = 0;
  virtual void remove(Space& space, Row row) = 0;

  /// Replaces the faults of one robot's actuator from the next tick on; an empty list repairs it. @throws ConfigError
  /// if a fault does not suit the device; then nothing has changed
  virtual void setFaults(const Space& space, Row row, const std::vector<ErrorModelDescription>& errors) = 0;
  /// The faults that were set last; empty for robots without such an actuator.
  virtual std::vector<ErrorModelDescription> faults(Row row) const = 0;
  /// Between ticks: later random draws use another seed.
  virtual void reseed(std::uint64_t seed) = 0;
  /// Between ticks, before the first one: gives all instances the state of robots that have just been added, with their
  /// present poses and the seed of the space; their mechanisms are at rest. @pre there are no faults
  virtual void restart(Space& space) = 0;
  /// Saves or loads the state of all instances, with their faults (state_archive.hpp), for snapshots of a run. When it
  /// loads, the actuator has instances for the same robots. An instance that adds members has a function `archive` for
  /// those that last from tick to tick, as instances of sensors.
  virtual void archive(const Space& space, StateArchive& state) = 0;

  /// Turns commands into actuation. Adds the rows of commands with a number that is not finite to `faulty`; their
  /// actuation keeps its previous value.
  virtual void actuate(const Space& space, const ActuateAccess& access, std::vector<Row>& faulty) = 0;
  /// The same on many threads, for actuators that handle each robot independently (ActuatorOf::is_by_robot_).
  virtual void actuate(const Space& space, const ActuateAccess& access, std::vector<Row>& faulty,
                       const Parallel& /*workers*/) {
    actuate(space, access, faulty);
  }
  /// Called after the engines have moved: updates data that depend on the new poses, such as the end of a laser beam.
  virtual void afterMove(const Space& /*space*/, const AfterMoveAccess& /*access*/) {}
  /// Replaces the robot's command by that of its safe stop and carries it out at once. Starts from the last finite
  /// command. Errors of <error> elements and faults act on it too.
  /// @return whether the stop is over: the command no longer changes
  virtual bool stop(const Space& space, const ActuateAccess& access, Row row, const SafeStopMoment& moment) = 0;

  /// Draws the actuators of the robots that the drawing is for. Changes nothing.
  virtual void draw(const Space& /*space*/, DeviceDrawing& /*drawing*/) const {}

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
  std::unique_ptr<DeviceFault> fault;  ///< null while this instance has no fault of its own
};

template <class Device, class Instance = BasicActuatorInstance<Device>>
class ActuatorOf : public Actuator {
  static_assert(kHasFields<Device>,
                "beside the device's struct stand its fields: swarmanoid_interface/device_type.hpp");

 public:
  using DeviceStruct = Device;

  void takeErrors(const std::vector<ErrorModelDescription>& errors) override { errors_.add(errors); }

  void* add(Space& space, Row row) override {
    Device* const command = &space.commands.template bank<Device>().add(row);
    instances_.push_back(makeInstance(space, row, command, &space.actuation.template bank<Device>().add(row)));
    if (!errors_.isEmpty()) {
      error_states_.push_back({row, errors_.makeState(space.seed, space.entities.name[row], 0)});
    }
    return command;
  }

  void remove(Space& space, Row row) override {
    space.commands.template bank<Device>().remove(row);
    space.actuation.template bank<Device>().remove(row);
    const auto is_meant = [&](const auto& candidate) { return candidate.row == row; };
    const auto has_fault = [&](const Instance& other) { return other.row == row && other.fault != nullptr; };
    fault_count_ -= static_cast<std::size_t>(std::count_if(instances_.begin(), instances_.end(), has_fault));
    instances_.erase(std::remove_if(instances_.begin(), instances_.end(), is_meant), instances_.end());
    error_states_.erase(std::remove_if(error_states_.begin(), error_states_.end(), is_meant), error_states_.end());
  }

  void setFaults(const Space& space, Row row, const std::vector<ErrorModelDescription>& errors) override {
    for (Instance& instance : instances_) {
      if (instance.row == row) {
        std::unique_ptr<DeviceFault> fault;
        if (!errors.empty()) {
          fault = std::make_unique<DeviceFault>(Device::kType, errors, space.seed, space.entities.name[row], 0);
        }
        fault_count_ -= instance.fault != nullptr ? 1 : 0;
        instance.fault = std::move(fault);
        fault_count_ += instance.fault != nullptr ? 1 : 0;
      }
    }
  }

  std::vector<ErrorModelDescription> faults(Row row) const override {
    for (const Instance& instance : instances_) {
      if (instance.row == row && instance.fault != nullptr) {
        return instance.fault->errors();
      }
    }
    return {};
  }

  void reseed(std::uint64_t seed) override {
    for (Instance& instance : instances_) {
      instance.random.reseed(seed);
      if (instance.fault != nullptr) {
        instance.fault->reseed(seed);
      }
    }
    for (Disturbed& disturbed : error_states_) {
      disturbed.errors.reseed(seed);
    }
  }

  void restart(Space& space) override {
    for (std::size_t k = 0; k < instances_.size(); ++k) {
      const Row row = instances_[k].row;
      Device* const command = instances_[k].command;
      Device* const actuation = instances_[k].actuation;
      *command = Device{};
      *actuation = Device{};
      instances_[k] = makeInstance(space, row, command, actuation);
      if (!errors_.isEmpty()) {
        error_states_[k].errors = errors_.makeState(space.seed, space.entities.name[row], 0);
      }
    }
  }

  void archive(const Space& space, StateArchive& state) override {
    for (std::size_t k = 0; k < instances_.size(); ++k) {
      archiveFaults(space, *this, instances_[k], state);
      Instance& instance = instances_[k];
      state(instance.random);
      archiveDevice(state, *instance.command);
      archiveDevice(state, *instance.actuation);
      archiveOwnMembers<BasicActuatorInstance<Device>>(state, instance);
      if (!errors_.isEmpty()) {
        state(error_states_[k].errors);
      }
      if (instance.fault != nullptr) {
        state(*instance.fault);
      }
    }
  }

  void actuate(const Space& space, const ActuateAccess& access, std::vector<Row>& faulty) override {
    actuateRange(space, access, faulty, 0, instances_.size());
  }

  void actuate(const Space& space, const ActuateAccess& access, std::vector<Row>& faulty,
               const Parallel& workers) override {
    if (!is_by_robot_) {
      actuate(space, access, faulty);
      return;
    }
    constexpr std::size_t kGrain = 512;
    std::mutex mutex;  // guards `faulty`, which is rarely written
    workers.forRanges(instances_.size(), kGrain, [&](std::size_t first, std::size_t last) {
      std::vector<Row> found;
      actuateRange(space, access, found, first, last);
      if (!found.empty()) {
        const std::lock_guard<std::mutex> lock(mutex);
        faulty.insert(faulty.end(), found.begin(), found.end());
      }
    });
  }

  bool stop(const Space& space, const ActuateAccess& access, Row row, const SafeStopMoment& moment) override {
    bool is_over = true;
    for (std::size_t k = 0; k < instances_.size(); ++k) {
      Instance& instance = instances_[k];
      if (instance.row == row) {
        if (!isFinite(*instance.command)) {
          *instance.command = *instance.actuation;
        }
        is_over = detail::stop(*instance.command, moment);
        if (errors_.hasListed() || instance.fault != nullptr) {
          // a stuck or late motor is stuck or late in a safe stop too
          *instance.actuation = *instance.command;
          if (errors_.hasListed()) {
            errors_.applyListed(instance.actuation, error_states_[k].errors, space.tick);
          }
          if (instance.fault != nullptr) {
            instance.fault->apply(instance.actuation, space.tick);
          }
          limit(space, instance);
        } else {
          detail::stop(*instance.actuation, moment);
        }
        apply(space, access, instance);
      }
    }
    return is_over;
  }

  void draw(const Space& space, DeviceDrawing& drawing) const override {
    for (const Instance& instance : instances_) {
      if (drawing.isOf(space.entities.name[instance.row])) {
        drawOne(space, instance, drawing);
      }
    }
  }

 protected:
  ActuatorOf() : Actuator(Device::kType) {}

  /// In `configure`: makes a parameter of this actuator mean an error; 0 means none.
  /// @param kind of the error @param field on which it acts, "" for all fields @param parameter of the kind
  void addErrorAlias(const char* kind, const char* field, const char* parameter, double value) {
    errors_.addAlias(kind, field, parameter, value);
  }

  /// Called before a new instance is added, for example to read the entity's model.
  virtual void prepareInstance(const Space&, Instance&) {}
  /// Limits and noise: changes instance.actuation, which starts as the command with its errors.
  virtual void limit(const Space&, Instance&) {}
  /// Passes the actuation on to the mechanisms (state/mechanisms.hpp), LEDs or radio tags. Called in each tick, and at
  /// rest when an instance is added.
  virtual void apply(const Space&, const ActuateAccess&, Instance&) {}
  /// Draws the actuator of one robot (device_drawing.hpp). The default draws nothing.
  virtual void drawOne(const Space&, const Instance&, DeviceDrawing&) const {}

  std::vector<Instance> instances_;
  /// True if `limit` and `apply` write only the data of the robot of their instance, and read nothing that those of
  /// other robots write. They are then called concurrently on many threads.
  bool is_by_robot_ = false;

 private:
  /// Error state of the instance with the same index; present only if there are errors.
  struct Disturbed {
    Row row;
    ErrorState errors;
  };

  /// Makes an instance whose mechanisms are commanded from now on, at rest.
  Instance makeInstance(Space& space, Row row, Device* command, Device* actuation) {
    Instance instance;
    instance.row = row;
    instance.number = space.entities.number[row];
    instance.command = command;
    instance.actuation = actuation;
    instance.random = RandomStream(space.seed, space.entities.name[row], Device::kType);
    prepareInstance(space, instance);
    apply(space, ActuateAccess(space), instance);
    return instance;
  }

  void actuateRange(const Space& space, const ActuateAccess& access, std::vector<Row>& faulty, std::size_t first,
                    std::size_t last) {
    if (errors_.isEmpty() && fault_count_ == 0) {
      actuateEach(space, access, faulty, first, last, [](std::size_t) {});
    } else if (fault_count_ == 0) {
      actuateEach(space, access, faulty, first, last,
                  [&](std::size_t k) { errors_.apply(instances_[k].actuation, error_states_[k].errors, space.tick); });
    } else {
      actuateEach(space, access, faulty, first, last, [&](std::size_t k) {
        if (!errors_.isEmpty()) {
          errors_.apply(instances_[k].actuation, error_states_[k].errors, space.tick);
        }
        if (DeviceFault* fault = instances_[k].fault.get()) {
          fault->apply(instances_[k].actuation, space.tick);
        }
      });
    }
  }

  /// @param disturb called with the index of an instance, after its command was copied to its actuation
  template <class Disturb>
  void actuateEach(const Space& space, const ActuateAccess& access, std::vector<Row>& faulty, std::size_t first,
                   std::size_t last, Disturb disturb) {
    for (std::size_t k = first; k < last; ++k) {
      Instance& instance = instances_[k];
      if (isFinite(*instance.command)) {
        *instance.actuation = *instance.command;
        disturb(k);
        limit(space, instance);
      } else {
        faulty.push_back(instance.row);
      }
      apply(space, access, instance);
    }
  }

  DeviceErrors errors_{Device::kType};
  std::vector<Disturbed> error_states_;
  std::size_t fault_count_ = 0;
};

}  // namespace swarmanoid

/// Registers an actuator; place it at the end of the source. `Class` has a static function
/// `PluginDescription describe()`. The robot type of the device comes from its struct.
#define REGISTER_ACTUATOR(Class)                                                                         \
  namespace {                                                                                            \
  const ::swarmanoid::PluginRegistration<::swarmanoid::Actuator, Class> SWARMANOID_CONCATENATE(          \
      registration_, __COUNTER__)(::swarmanoid::PluginKind::kActuator,                                   \
                                  ::swarmanoid::describeDevice<Class::DeviceStruct>(Class::describe())); \
  }

/// The base classes of simulated sensors. One object serves all robots of one controller configuration: it reads the
/// space and fills their readings, the structs of swarmanoid_interface/devices.
///
/// Phases   configure, add, remove, setFaults, archive: between ticks. prepare, then sense: the phase of this name,
/// with const
///          access to the space. draw: in `show` or between ticks, if a viewer is active.
/// Threads  sense is called concurrently on disjoint ranges of instances. No allocation, lock, log or throw in it.
/// Noise    drawn from the instance's own stream, so it does not depend on other instances.
/// Errors   errors of <error> elements act on a copy of the readings that `sense` has filled in. addErrorAlias makes a
///          parameter of the sensor mean such an error. The alias draws from a stream of the same name as the
///          instance's own stream, so both give the same numbers: a sensor that draws random numbers itself should
///          have no aliases that draw. Faults of single robots (setFaults) act after these errors.
///
/// State    an instance that adds members has a function `archive` for those that last from tick to tick, which may be
///          empty; members of the sensor itself are parameters, or are filled in by `prepare` or `sense`. Otherwise
///          override archive. A sensor whose instances lack the function has no snapshots.
///
/// To add a sensor: write its struct and descriptor in an interface header, derive from SensorOf<Struct>, end with
/// REGISTER_SENSOR.
#pragma once

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "swarmanoid_interface/configuration.hpp"
#include "swarmanoid_interface/device_type.hpp"
#include "swarmanoid_interface/random.hpp"
#include "swarmanoid_interface/registry.hpp"
#include "swarmanoid_interface/state_archive.hpp"
#include "swarmanoid_space/access.hpp"
#include "swarmanoid_space/archive_device.hpp"
#include "swarmanoid_space/device_description.hpp"
#include "swarmanoid_space/device_drawing.hpp"
#include "swarmanoid_space/error_models/device_errors.hpp"
#include "swarmanoid_space/error_models/device_fault.hpp"
#include "swarmanoid_space/space.hpp"

namespace swarmanoid {

class Sensor {
 public:
  using DeviceStruct = void;  ///< defined by SensorOf

  virtual ~Sensor() = default;

  /// @throws ConfigError
  virtual void configure(const Configuration& parameters) = 0;

  /// Called after `configure`. @throws ConfigError if the errors do not suit the device
  virtual void takeErrors(const std::vector<ErrorModelDescription>& errors) = 0;

  /// Adds the instance of a robot. @return its readings, valid as long as the robot lives
  virtual const void* add(Space& space, Row row) = 0;
  virtual void remove(Space& space, Row row) = 0;

  /// Replaces the faults of one robot's sensor from the next tick on; an empty list repairs it. @throws ConfigError if
  /// a fault does not suit the device; then nothing has changed
  virtual void setFaults(const Space& space, Row row, const std::vector<ErrorModelDescription>& errors) = 0;
  /// The faults that were set last; empty for robots without such a sensor.
  virtual std::vector<ErrorModelDescription> faults(Row row) const = 0;
  /// Between ticks: later random draws use another seed.
  virtual void reseed(std::uint64_t seed) = 0;
  /// Between ticks, before the first one: gives all instances the state of robots that have just been added, with their
  /// present poses and the seed of the space. @pre there are no faults
  virtual void restart(const Space& space) = 0;
  /// Saves or loads the state of all instances, with their faults (state_archive.hpp), for snapshots of a run. When it
  /// loads, the sensor has instances for the same robots.
  virtual void archive(const Space& space, StateArchive& state) = 0;

  virtual std::size_t instanceCount() const = 0;
  /// Called on one thread before the ranges are sensed; computes data that all instances share.
  virtual void prepare(const Space&) {}
  /// Updates the readings of instances first .. last - 1, which are in the order of entity numbers.
  virtual void sense(const Space& space, std::size_t first, std::size_t last) = 0;
  /// The same, followed by errors and faults.
  void update(const Space& space, std::size_t first, std::size_t last) {
    sense(space, first, last);
    if (delivers_) {
      deliver(space, first, last);
    }
  }
  /// Called on one thread after all ranges are sensed; reports events such as an overflow.
  virtual void report(const Space& /*space*/, const ReportAccess& /*access*/) {}

  /// Draws the sensors of the robots that the drawing is for. Changes nothing.
  virtual void draw(const Space& /*space*/, DeviceDrawing& /*drawing*/) const {}

  const char* type() const { return type_; }

 protected:
  explicit Sensor(const char* type) : type_(type) {}

  /// Copies readings to the structs that controllers read, with their errors.
  virtual void deliver(const Space& space, std::size_t first, std::size_t last) = 0;

  bool delivers_ = false;  ///< there are errors, or a robot has faults

 private:
  const char* type_;
};

/// The faults of the sensor of one robot.
template <class Device>
struct SensorFault {
  DeviceFault errors;
  Device* delivered = nullptr;  ///< the struct that the controller reads
  /// The readings without errors, if the configuration has no errors; otherwise unused, since they are stored
  /// elsewhere.
  Device readings{};
};

/// The sensor of one robot, in the bank of its type.
template <class Device>
struct BasicSensorInstance {
  Row row = kNoRow;
  EntityNumber number = kNoEntity;
  Device* readings = nullptr;  ///< without errors
  RandomStream random;
  std::unique_ptr<SensorFault<Device>> fault;  ///< null while this instance has no fault of its own
};

/// A sensor whose readings are a `Device`. `Instance` may be replaced by a struct that derives from BasicSensorInstance
/// and adds members.
template <class Device, class Instance = BasicSensorInstance<Device>>
class SensorOf : public Sensor {
  static_assert(kHasFields<Device>,
                "beside the device's struct stand its fields: swarmanoid_interface/device_type.hpp");

 public:
  using DeviceStruct = Device;

  void takeErrors(const std::vector<ErrorModelDescription>& errors) override {
    errors_.add(errors);
    chooseDelivery();
  }

  const void* add(Space& space, Row row) override {
    Device& delivered = space.readings.template bank<Device>().add(row);
    Device* readings = &delivered;
    Disturbed disturbed{row, nullptr, &delivered, {}};
    if (!errors_.isEmpty()) {
      // the readings are stored separately, since a sensor may continue from its previous readings
      disturbed.readings = std::make_unique<Device>();
      disturbed.errors = errors_.makeState(space.seed, space.entities.name[row], mostElements());
      readings = disturbed.readings.get();
    }
    // entity numbers only grow, so the order is kept
    instances_.push_back(makeInstance(space, row, readings));
    if (!errors_.isEmpty()) {
      disturbed_.push_back(std::move(disturbed));
    }
    return &delivered;
  }

  void remove(Space& space, Row row) override {
    space.readings.template bank<Device>().remove(row);
    const auto is_meant = [&](const auto& candidate) { return candidate.row == row; };
    forget(row);
    instances_.erase(std::remove_if(instances_.begin(), instances_.end(), is_meant), instances_.end());
    disturbed_.erase(std::remove_if(disturbed_.begin(), disturbed_.end(), is_meant), disturbed_.end());
  }

  void setFaults(const Space& space, Row row, const std::vector<ErrorModelDescription>& errors) override {
    const std::size_t k = indexOf(row);
    if (k == instances_.size()) {
      return;
    }
    std::unique_ptr<SensorFault<Device>> fault;
    if (!errors.empty()) {
      fault.reset(new SensorFault<Device>{
          {Device::kType, errors, space.seed, space.entities.name[row], mostElements()}, nullptr, {}});
    }
    mend(k);
    if (fault != nullptr) {
      begin(k, std::move(fault));
    }
  }

  std::vector<ErrorModelDescription> faults(Row row) const override {
    const std::size_t k = indexOf(row);
    return k == instances_.size() || instances_[k].fault == nullptr ? std::vector<ErrorModelDescription>()
                                                                    : instances_[k].fault->errors.errors();
  }

  void reseed(std::uint64_t seed) override {
    for (Instance& instance : instances_) {
      instance.random.reseed(seed);
      if (instance.fault != nullptr) {
        instance.fault->errors.reseed(seed);
      }
    }
    for (Disturbed& disturbed : disturbed_) {
      disturbed.errors.reseed(seed);
    }
  }

  void restart(const Space& space) override {
    for (std::size_t k = 0; k < instances_.size(); ++k) {
      const Row row = instances_[k].row;
      Device* const readings = instances_[k].readings;
      *readings = Device{};
      if (!errors_.isEmpty()) {
        *disturbed_[k].delivered = Device{};
        disturbed_[k].errors = errors_.makeState(space.seed, space.entities.name[row], mostElements());
      }
      instances_[k] = makeInstance(space, row, readings);
    }
  }

  void archive(const Space& space, StateArchive& state) override {
    for (std::size_t k = 0; k < instances_.size(); ++k) {
      archiveFaults(space, *this, instances_[k], state);
      Instance& instance = instances_[k];
      state(instance.random);
      archiveDevice(state, *instance.readings);
      archiveOwnMembers<BasicSensorInstance<Device>>(state, instance);
      if (!errors_.isEmpty()) {
        archiveDelivered(state, *instance.readings, *disturbed_[k].delivered);
        state(disturbed_[k].errors);
        errors_.pointSpans(disturbed_[k].delivered, disturbed_[k].errors);
      }
      if (instance.fault != nullptr) {
        archiveDelivered(state, *instance.readings, *instance.fault->delivered);
        state(instance.fault->errors);
        instance.fault->errors.pointSpans(instance.fault->delivered);
      }
    }
  }

  std::size_t instanceCount() const override { return instances_.size(); }

  void draw(const Space& space, DeviceDrawing& drawing) const override {
    for (const Instance& instance : instances_) {
      if (drawing.isOf(space.entities.name[instance.row])) {
        drawOne(space, instance, drawing);
      }
    }
  }

 protected:
  SensorOf() : Sensor(Device::kType) {}

  /// In `configure`: makes a parameter of this sensor mean an error; 0 means none.
  /// @param kind of the error @param field on which it acts, "" for all fields @param parameter of the kind
  void addErrorAlias(const char* kind, const char* field, const char* parameter, double value) {
    errors_.addAlias(kind, field, parameter, value);
    chooseDelivery();
  }
  /// Maximum number of elements of a span of the readings; errors on spans reserve memory for this many.
  virtual std::size_t mostElements() const { return 0; }

  /// Called before a new instance is added, for example to read the entity's model.
  virtual void prepareInstance(const Space&, Instance&) {}

  /// Draws the sensor of one robot (device_drawing.hpp). The default draws nothing.
  virtual void drawOne(const Space&, const Instance&, DeviceDrawing&) const {}
  /// For drawOne: the readings of the robot's controller, with errors and faults.
  /// @pre the instance is one of instances_
  const Device& delivered(const Instance& instance) const {
    if (errors_.isEmpty()) {
      return instance.fault == nullptr ? *instance.readings : *instance.fault->delivered;
    }
    return *disturbed_[static_cast<std::size_t>(&instance - instances_.data())].delivered;
  }

  void deliver(const Space& space, std::size_t first, std::size_t last) override {
    if (!errors_.isEmpty()) {
      for (std::size_t k = first; k < last; ++k) {
        Disturbed& disturbed = disturbed_[k];
        *disturbed.delivered = *disturbed.readings;
        errors_.apply(disturbed.delivered, disturbed.errors, space.tick);
      }
    }
    if (fault_count_ > 0) {
      for (std::size_t k = first; k < last; ++k) {
        if (SensorFault<Device>* fault = instances_[k].fault.get()) {
          deliverFault(*fault, space.tick);
        }
      }
    }
  }

  std::vector<Instance> instances_;

 private:
  /// Error state of the instance with the same index; present only if there are errors.
  struct Disturbed {
    Row row;
    std::unique_ptr<Device> readings;
    Device* delivered;
    ErrorState errors;
  };

  /// Saves or loads what controllers read. Spans without errors are those of the readings.
  static void archiveDelivered(StateArchive& state, const Device& readings, Device& delivered) {
    if (state.isLoading()) {
      delivered = readings;
    }
    archiveDevice(state, delivered);
  }

  Instance makeInstance(const Space& space, Row row, Device* readings) {
    Instance instance;
    instance.row = row;
    instance.number = space.entities.number[row];
    instance.readings = readings;
    instance.random = RandomStream(space.seed, space.entities.name[row], Device::kType);
    prepareInstance(space, instance);
    return instance;
  }

  void chooseDelivery() { delivers_ = !errors_.isEmpty() || fault_count_ > 0; }

  /// @return the number of instances if the row has none
  std::size_t indexOf(Row row) const {
    const auto found =
        std::find_if(instances_.begin(), instances_.end(), [&](const Instance& other) { return other.row == row; });
    return static_cast<std::size_t>(found - instances_.begin());
  }

  void deliverFault(SensorFault<Device>& fault, std::uint64_t tick) {
    if (errors_.isEmpty()) {
      *fault.delivered = fault.readings;
    }
    fault.errors.apply(fault.delivered, tick);
  }

  void begin(std::size_t k, std::unique_ptr<SensorFault<Device>> fault) {
    Instance& instance = instances_[k];
    if (errors_.isEmpty()) {
      fault->delivered = instance.readings;
      fault->readings = *instance.readings;
      instance.readings = &fault->readings;
    } else {
      fault->delivered = disturbed_[k].delivered;
    }
    instance.fault = std::move(fault);
    ++fault_count_;
    chooseDelivery();
  }

  /// Removes a fault. Updates the readings at once, since their spans may point into the fault.
  void mend(std::size_t k) {
    Instance& instance = instances_[k];
    if (instance.fault == nullptr) {
      return;
    }
    Device* const delivered = instance.fault->delivered;
    if (errors_.isEmpty()) {
      *delivered = instance.fault->readings;
      instance.readings = delivered;
    } else {
      // apply the errors of the last tick again
      Disturbed& disturbed = disturbed_[k];
      *delivered = *disturbed.readings;
      if (disturbed.errors.tick != ErrorState::kNoTick) {
        errors_.apply(delivered, disturbed.errors, disturbed.errors.tick);
      }
    }
    instance.fault.reset();
    --fault_count_;
    chooseDelivery();
  }

  /// Drops the fault of a robot that is deleted together with its readings.
  void forget(Row row) {
    const std::size_t k = indexOf(row);
    if (k < instances_.size() && instances_[k].fault != nullptr) {
      instances_[k].fault.reset();
      --fault_count_;
      chooseDelivery();
    }
  }

  DeviceErrors errors_{Device::kType};
  std::vector<Disturbed> disturbed_;
  std::size_t fault_count_ = 0;
};

}  // namespace swarmanoid

/// Registers a sensor; place it at the end of the source. `Class` has a static function `PluginDescription describe()`.
/// The robot type of the device comes from its struct.
#define REGISTER_SENSOR(Class)                                                                           \
  namespace {                                                                                            \
  const ::swarmanoid::PluginRegistration<::swarmanoid::Sensor, Class> SWARMANOID_CONCATENATE(            \
      registration_, __COUNTER__)(::swarmanoid::PluginKind::kSensor,                                     \
                                  ::swarmanoid::describeDevice<Class::DeviceStruct>(Class::describe())); \
  }

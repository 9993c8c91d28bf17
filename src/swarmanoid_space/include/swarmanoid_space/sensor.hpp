/// The base classes of simulated sensors. One object serves all robots of one controller configuration: it reads the
/// space and fills their readings, the structs of swarmanoid_interface/devices.
///
/// Phases   configure, add, remove: between ticks. sense: the phase of this name; sees the space const.
/// Threads  sense is called at once on disjoint ranges of instances. No allocation, lock, log or throw in it.
/// Noise    drawn from the instance's own stream, so it does not depend on other instances.
///
/// To add a sensor: write its struct and descriptor in an interface header, derive from SensorOf<Struct>, end with
/// REGISTER_SENSOR.
#pragma once

#include <algorithm>
#include <vector>

#include "swarmanoid_interface/configuration.hpp"
#include "swarmanoid_interface/device_type.hpp"
#include "swarmanoid_interface/random.hpp"
#include "swarmanoid_interface/registry.hpp"
#include "swarmanoid_space/space.hpp"

namespace swarmanoid {

class Sensor {
 public:
  virtual ~Sensor() = default;

  /// @throws ConfigError
  virtual void configure(const Configuration& parameters) = 0;

  /// Adds the instance of a robot. @return where its readings will be, for as long as the robot lives
  virtual const void* add(Space& space, Row row) = 0;
  virtual void remove(Space& space, Row row) = 0;

  virtual std::size_t instanceCount() const = 0;
  /// Refreshes the readings of instances first .. last - 1, which are in the order of entity numbers.
  virtual void sense(const Space& space, std::size_t first, std::size_t last) = 0;
  /// After all ranges are sensed, on one thread: events such as an overflow.
  virtual void report(Space&) {}

  const char* type() const { return type_; }

 protected:
  explicit Sensor(const char* type) : type_(type) {}

 private:
  const char* type_;
};

/// The sensor of one robot, in the bank of its type.
template <class Device>
struct BasicSensorInstance {
  Row row = kNoRow;
  EntityNumber number = kNoEntity;
  Device* readings = nullptr;
  RandomStream random;
};

/// A sensor whose readings are a `Device`. `Instance` may be replaced by a struct that derives from BasicSensorInstance
/// and has more.
template <class Device, class Instance = BasicSensorInstance<Device>>
class SensorOf : public Sensor {
  static_assert(kHasFields<Device>,
                "beside the device's struct stand its fields: swarmanoid_interface/device_type.hpp");

 public:
  const void* add(Space& space, Row row) override {
    Instance instance;
    instance.row = row;
    instance.number = space.entities.number[static_cast<std::size_t>(row)];
    instance.readings = &space.readings.template bank<Device>().add(row);
    instance.random = RandomStream(space.seed, space.entities.name[static_cast<std::size_t>(row)], Device::kType);
    prepareInstance(space, instance);
    const Device* readings = instance.readings;
    // entity numbers only grow, so the order is kept
    instances_.push_back(std::move(instance));
    return readings;
  }

  void remove(Space& space, Row row) override {
    space.readings.template bank<Device>().remove(row);
    instances_.erase(std::remove_if(instances_.begin(), instances_.end(),
                                    [&](const Instance& instance) { return instance.row == row; }),
                     instances_.end());
  }

  std::size_t instanceCount() const override { return instances_.size(); }

 protected:
  SensorOf() : Sensor(Device::kType) {}

  /// Last chance to prepare a new instance, such as from the entity's model.
  virtual void prepareInstance(const Space&, Instance&) {}

  std::vector<Instance> instances_;
};

}  // namespace swarmanoid

/// At the end of a sensor's source. `Class` has a static function `PluginDescription describe()`.
#define REGISTER_SENSOR(Class)                                                                \
  namespace {                                                                                 \
  const ::swarmanoid::PluginRegistration<::swarmanoid::Sensor, Class> SWARMANOID_CONCATENATE( \
      registration_, __COUNTER__)(::swarmanoid::PluginKind::kSensor, Class::describe());      \
  }

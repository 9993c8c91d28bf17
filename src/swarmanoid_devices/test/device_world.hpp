/// Worlds small enough to compute by hand: a space without engines and controllers, and devices from the registry. Rays
/// also hit entities that are in no engine.
#pragma once

#include <Eigen/Geometry>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "swarmanoid_experiment_files/robots/robot_model.hpp"
#include "swarmanoid_interface/plugin_library.hpp"
#include "swarmanoid_space/actuator.hpp"
#include "swarmanoid_space/sensor.hpp"

namespace swarmanoid::test {

constexpr double kDegree = M_PI / 180.0;

using Parameters = std::map<std::string, std::string>;
using Errors = std::vector<ErrorModelDescription>;

/// Makes a device as an experiment file would configure it; omitted parameters have their defaults. The parameter
/// `implementation` selects an implementation, as its element does.
template <class Base>
std::shared_ptr<Base> makeDevice(PluginKind kind, const std::string& type, const Parameters& parameters,
                                 const Errors& errors = {}) {
  loadPluginLibrary("swarmanoid_devices", {}, {});
  const auto implementation = parameters.find("implementation");
  const Registry::Entry& entry =
      *Registry::instance().find(kind, type, implementation == parameters.end() ? "" : implementation->second);
  Configuration configuration(type, "", {});
  for (const Parameter& parameter : entry.description.parameters) {
    const auto given = parameters.find(parameter.name);
    configuration.set(parameter.name, given == parameters.end() ? parameter.value.value_or("") : given->second);
  }
  auto device = makePlugin<Base>(entry);
  device->configure(configuration);
  device->takeErrors(errors);
  return device;
}

class DeviceWorld {
 public:
  explicit DeviceWorld(std::uint64_t seed = 1) {
    space.seed = seed;
    space.size = {10.0, 10.0, 3.0};
    space.clocktick = std::chrono::milliseconds(100);
    space.index.configure(space.size, PositionalIndex::Optimization::k2D, 16);
    space.entities_without_engine.configure(space.size);
  }

  Row add(const std::shared_ptr<const EntityModel>& model, const Eigen::Vector3d& position, double heading = 0.0,
          Color color = colors::kBlack) {
    const Pose pose{position, Eigen::Quaterniond(Eigen::AngleAxisd(heading, Eigen::Vector3d::UnitZ()))};
    const Row row = space.entities.add("e" + std::to_string(++count_), model, pose, color);
    space.entities_without_engine.place(space.entities, row);
    return row;
  }
  Row addFootbot(double x, double y, double heading = 0.0) { return add(robotModel("footbot"), {x, y, 0.0}, heading); }
  Row addEyebot(double x, double y, double z, double heading = 0.0) {
    return add(robotModel("eyebot"), {x, y, z}, heading);
  }
  Row addPrey(double x, double y, Color color = colors::kYellow, double radius = 0.06, double height = 0.1) {
    return add(cylindricPreyModel(radius, height), {x, y, 0.0}, 0.0, color);
  }
  /// Adds a wall that stands on the floor. @param centre of its base
  Row addWall(const Eigen::Vector3d& size, const Eigen::Vector2d& centre) {
    return add(blockModel(size), {centre.x(), centre.y(), 0.5 * size.z()});
  }
  void remove(Row row) {
    space.entities_without_engine.remove(row);
    space.entities.remove(row);
  }

  Pose& pose(Row row) { return space.entities.pose[row]; }

  /// Updates the index and the rays after changes of poses.
  void takePoses() {
    space.entities_without_engine.refresh(space.entities);
    space.index.rebuild(space.entities);
  }

  /// Updates all instances of a sensor from the current state of the space.
  void sense(Sensor& sensor) {
    takePoses();
    sensor.prepare(space);
    sensor.update(space, 0, sensor.instanceCount());
    sensor.report(space, ReportAccess(space));
  }

  /// @return rows with invalid commands
  std::vector<Row> actuate(Actuator& actuator) {
    std::vector<Row> faulty;
    actuator.actuate(space, ActuateAccess(space), faulty);
    return faulty;
  }

  Space space;

 private:
  int count_ = 0;
};

/// One sensor of one robot.
template <class Device>
class SensorUnderTest {
 public:
  SensorUnderTest(DeviceWorld& world, Row row, const Parameters& parameters = {}, const Errors& errors = {})
      : world_(world),
        sensor(makeDevice<Sensor>(PluginKind::kSensor, Device::kType, parameters, errors)),
        readings_(static_cast<const Device*>(sensor->add(world.space, row))) {}

  const Device& sense() {
    world_.sense(*sensor);
    return *readings_;
  }

 private:
  DeviceWorld& world_;

 public:
  std::shared_ptr<Sensor> sensor;

 private:
  const Device* readings_;
};

/// One actuator of one robot.
template <class Device>
class ActuatorUnderTest {
 public:
  ActuatorUnderTest(DeviceWorld& world, Row row, const Parameters& parameters = {}, const Errors& errors = {})
      : world_(world),
        row_(row),
        actuator(makeDevice<Actuator>(PluginKind::kActuator, Device::kType, parameters, errors)),
        command(*static_cast<Device*>(actuator->add(world.space, row))) {}

  /// Applies a safe stop that began `since` seconds ago. @return whether it is over
  bool stop(double since = 0.0) {
    return actuator->stop(world_.space, ActuateAccess(world_.space), row_, {since, {}, robot_});
  }

  /// Returns the command after this tick's limits and noise.
  const Device& actuate() {
    faulty = world_.actuate(*actuator);
    return *world_.space.actuation.find<Device>(row_);
  }

 private:
  DeviceWorld& world_;
  Row row_;
  Robot robot_{"robot", "footbot", 1};  // robot for the safe stop, without sensors

 public:
  std::shared_ptr<Actuator> actuator;
  Device& command;
  std::vector<Row> faulty;  ///< result of the last actuate
};

/// Mean and standard deviation.
struct Statistics {
  double mean = 0.0;
  double deviation = 0.0;

  explicit Statistics(const std::vector<double>& values) {
    for (const double value : values) {
      mean += value / static_cast<double>(values.size());
    }
    double sum = 0.0;
    for (const double value : values) {
      sum += (value - mean) * (value - mean);
    }
    deviation = std::sqrt(sum / static_cast<double>(values.size()));
  }
};

/// Tries to add the device to a robot of the model. @tparam UnderTest an ActuatorUnderTest or a SensorUnderTest
/// @return reason of the refusal, or "" if the robot may have the device
template <class UnderTest>
std::string refusalOf(const std::shared_ptr<const EntityModel>& model) {
  DeviceWorld world;
  try {
    UnderTest device(world, world.add(model, {1.0, 1.0, 0.0}));
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "";
}

/// An <error> that adds an offset to a field.
inline ErrorModelDescription bias(const std::string& field, const std::string& offset) {
  ErrorModelDescription error;
  error.kind = "bias";
  error.field = field;
  error.parameters = Configuration("error", "", {});
  error.parameters.set("offset", offset);
  return error;
}

}  // namespace swarmanoid::test

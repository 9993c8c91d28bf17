// `swarmanoid check-robot`: lists all problems of a robot's description at once, or the capabilities of the robot.
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "../commands.hpp"
#include "../installed_plugins.hpp"
#include "../output/standard_output.hpp"
#include "swarmanoid_experiment_files/robots/robot_model.hpp"
#include "swarmanoid_interface/configuration.hpp"
#include "swarmanoid_interface/contains.hpp"
#include "swarmanoid_interface/plain_text.hpp"
#include "swarmanoid_space/actuator.hpp"
#include "swarmanoid_space/engine.hpp"
#include "swarmanoid_space/models/entity_model.hpp"
#include "swarmanoid_space/sensor.hpp"

namespace swarmanoid::program {
namespace {

using ModelPointer = std::shared_ptr<const EntityModel>;

std::string refusalFor(const Registry::Entry& device, const Configuration& parameters, const ModelPointer& robot) {
  Space space;
  const Row row = space.entities.add("robot", robot, {}, colors::kBlack);
  try {
    if (device.kind == PluginKind::kSensor) {
      const auto sensor = makePlugin<Sensor>(device);
      sensor->configure(parameters);
      sensor->add(space, row);
    } else {
      const auto actuator = makePlugin<Actuator>(device);
      actuator->configure(parameters);
      actuator->add(space, row);
    }
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "";
}

/// Adds a device to the robot, with its default parameters. @return reason why the robot cannot have it, or ""
std::string missingFor(const Registry::Entry& device, const ModelPointer& robot) {
  for (const Mechanism& mechanism : device.description.mechanisms) {
    if (const std::string part = robot->missingPart(mechanism); !part.empty()) {
      return "found no " + part + ", allowed: robots with " + part;
    }
  }
  Configuration parameters(device.description.label, "", {});
  for (const Parameter& parameter : device.description.parameters) {
    if (!parameter.value) {
      return "";  // required parameters have no value to try
    }
    parameters.set(parameter.name, *parameter.value);
  }
  return refusalFor(device, parameters, robot);
}

/// The default implementations of the devices that such a robot may have.
std::vector<const Registry::Entry*> devicesFor(const EntityModel& robot) {
  std::vector<const Registry::Entry*> devices;
  for (const PluginKind kind : {PluginKind::kSensor, PluginKind::kActuator}) {
    for (const Registry::Entry* entry : Registry::instance().all(kind)) {
      const PluginDescription& description = entry->description;
      const bool may_have_it = description.robots.empty() || contains(description.robots, robot.type) ||
                               contains(robot.devices, description.label);
      if (may_have_it && Registry::instance().find(kind, description.label) == entry) {
        devices.push_back(entry);
      }
    }
  }
  return devices;
}

/// Adds devices of the description that no library provides.
void addUnknownDevices(const std::string& file, const EntityModel& robot, std::vector<std::string>& problems) {
  std::vector<std::string> known;
  for (const PluginKind kind : {PluginKind::kSensor, PluginKind::kActuator}) {
    const std::vector<std::string> labels = Registry::instance().labels(kind);
    known.insert(known.end(), labels.begin(), labels.end());
  }
  for (const std::string& device : robot.devices) {
    if (!contains(known, device)) {
      problems.push_back(ConfigError({file}, unknownName("<device type=...>", device, known)).what());
    }
  }
}

void writeBody(const EntityModel& robot, std::ostream& out) {
  out << robot.type << ": " << robot.mass << " kg, within " << robot.horizontal_radius << " m of its middle, up to "
      << robot.highest << " m high\n";
  if (robot.wheels) {
    const EntityModel::Wheels& wheels = *robot.wheels;
    out << "wheels: radius " << wheels.radius << " m, " << wheels.separation << " m apart, at most " << wheels.max_speed
        << " rad/s (" << wheels.max_speed * wheels.radius << " m/s)\n";
  }
  for (const EntityModel::Joint& joint : robot.joints) {
    out << "joint: " << joint.name << ", at most " << joint.max_speed << " rad/s and " << joint.max_effort << " N m\n";
  }
}

void writeEngines(const EntityModel& robot, std::ostream& out) {
  for (const Registry::Entry* entry : Registry::instance().all(PluginKind::kEngine)) {
    const std::string reason = makePlugin<Engine>(*entry)->unsupportedReason(robot, {});
    out << "engine: " << entry->description.label << (reason.empty() ? "" : ", no: the robot " + reason) << '\n';
  }
}

void writeDevices(const ModelPointer& robot, std::ostream& out) {
  std::vector<std::string> refusals;
  for (const Registry::Entry* device : devicesFor(*robot)) {
    const std::string& name = device->description.label;
    const std::string reason = missingFor(*device, robot);
    if (reason.empty()) {
      out << "device: " << name << '\n';
    } else {
      refusals.push_back("not: " + name + ": " + reason + '\n');
    }
  }
  for (const std::string& refusal : refusals) {
    out << refusal;
  }
}

ExitCode checkRobot(const std::string& file) {
  loadInstalledPlugins();
  std::vector<std::string> problems;
  const ModelPointer robot = checkRobotFile(std::filesystem::path(file).stem().string(), file, problems);
  if (robot != nullptr) {
    addUnknownDevices(file, *robot, problems);
  }
  for (const std::string& problem : problems) {
    std::cerr << "swarmanoid: " << problem << '\n';
  }
  if (!problems.empty()) {
    return ExitCode::kBadInput;
  }
  PlainTextStream out;
  out.precision(4);
  writeBody(*robot, out);
  writeEngines(*robot, out);
  writeDevices(robot, out);
  print(out.str());
  return ExitCode::kFinished;
}

}  // namespace

Command addCheckRobotCommand(CLI::App& app) {
  auto file = std::make_shared<std::string>();
  CLI::App* command =
      app.add_subcommand("check-robot", "list what is wrong with a robot's description, or what the robot can do");
  command->add_option("file", *file, "its URDF")->required();
  return [file] { return checkRobot(*file); };
}

}  // namespace swarmanoid::program

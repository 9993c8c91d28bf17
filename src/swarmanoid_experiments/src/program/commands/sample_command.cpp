// `swarmanoid sample`: a table of a sensor's readings, for its implementation `sampled`.
#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "../commands.hpp"
#include "../installed_plugins.hpp"
#include "../sample_world.hpp"
#include "swarmanoid_experiment_files/override_text.hpp"
#include "swarmanoid_experiment_files/samples/sample_table.hpp"
#include "swarmanoid_interface/device_type.hpp"
#include "swarmanoid_recording/output/out_folder.hpp"
#include "swarmanoid_space/experiment/experiment.hpp"

namespace swarmanoid::program {
namespace {

struct SampleOptions {
  std::string device;
  std::string robot;
  std::string out;
  std::int64_t sensor = 0;
  std::string distances;
  std::string angles;
  std::vector<std::string> settings;
  bool force = false;
};

constexpr std::size_t kMostOnAxis = 1000;
constexpr double kDigits = 1e9;  // of distances and angles: 1 nm, 1e-9 degrees

/// The values FIRST, FIRST + STEP, ... up to LAST.
std::vector<double> valuesOf(const std::string& text, const std::string& option, Range range) {
  const SourceLocation location{option, 0};
  const std::size_t first = text.find(':');
  const std::size_t second = first == std::string::npos ? first : text.find(':', first + 1);
  if (second == std::string::npos) {
    throw ConfigError(location, "found '" + text + "', allowed: FIRST:STEP:LAST");
  }
  const double begin = parseNumber(text.substr(0, first), "FIRST", location, range);
  const double step = parseNumber(text.substr(first + 1, second - first - 1), "STEP", location, {1e-6, kInfinity});
  const double end = parseNumber(text.substr(second + 1), "LAST", location, {begin, range.maximum});
  const double count = std::floor((end - begin) / step + 1e-6) + 1.0;
  if (count > static_cast<double>(kMostOnAxis)) {
    throw ConfigError(location, "found '" + text + "', which are " + numberText(count) + " values, allowed: at most " +
                                    std::to_string(kMostOnAxis));
  }
  std::vector<double> values;
  for (int i = 0; i < static_cast<int>(count); ++i) {
    values.push_back(std::round((begin + i * step) * kDigits) / kDigits);
  }
  return values;
}

/// 20 steps up to the reach; for light without 0, where the lamp would be in the sensor.
std::vector<double> usualDistances(const SampleWorld& world) {
  constexpr int kSteps = 20;
  std::vector<double> values;
  for (int i = world.stimulus() == Stimulus::kLight ? 1 : 0; i <= kSteps; ++i) {
    values.push_back(std::round(world.reach() * i / kSteps * kDigits) / kDigits);
  }
  return values;
}

std::vector<double> distancesOf(const SampleWorld& world, const std::string& text) {
  if (text.empty()) {
    return usualDistances(world);
  }
  std::vector<double> values = valuesOf(text, "--distances", SampleTable::kDistances);
  if (world.stimulus() == Stimulus::kLight && values.front() <= 0.0) {
    throw ConfigError({"--distances", 0},
                      "found '" + text + "', which puts a lamp into the sensor, allowed: FIRST above 0");
  }
  return values;
}

/// The wall has a limited width: at a grazing angle the sensor would miss it.
Range allowedAngles(const SampleWorld& world) {
  constexpr double kSteepest = 89.0;  // deg
  return world.stimulus() == Stimulus::kObstacle ? Range{0.0, kSteepest} : SampleTable::kAngles;
}

/// Up to 80 degrees; for light up to 90, the limit of the sensors' field of view.
std::vector<double> anglesOf(const SampleWorld& world, const std::string& text) {
  const char* usual = world.stimulus() == Stimulus::kLight ? "0:10:90" : "0:10:80";
  return valuesOf(text.empty() ? usual : text, "--angles", allowedAngles(world));
}

const Registry::Entry& requireSampled(const std::string& device) {
  std::vector<std::string> known;
  for (const Registry::Entry* entry : Registry::instance().all(PluginKind::kSensor)) {
    if (entry->description.implementation == "sampled") {
      known.push_back(entry->description.label);
      if (entry->description.label == device) {
        return *entry;
      }
    }
  }
  throw ConfigError({"sample", 0}, unknownName("the sensor", device, known));
}

/// The parameters of the default implementation, with the values from --set.
Configuration parametersOf(const PluginDescription& ideal, const std::vector<std::string>& settings) {
  Configuration parameters(ideal.label, "", {});
  std::vector<Override> given;
  for (const std::string& setting : settings) {
    given.push_back(parseOverride(setting, "--set"));
  }
  std::vector<std::string> names;
  for (const Parameter& parameter : ideal.parameters) {
    names.push_back(parameter.name);
    const auto is_meant = [&](const Override& setting) { return setting.path == parameter.name; };
    const auto found = std::find_if(given.rbegin(), given.rend(), is_meant);
    const std::string text = found == given.rend() ? parameter.value.value_or("") : found->value;
    if (parameter.type == Parameter::Type::kNumber) {
      parseNumber(text, parameter.name, {"--set", 0}, parameter.range);
    }
    parameters.set(parameter.name, text);
  }
  for (const Override& setting : given) {
    if (std::find(names.begin(), names.end(), setting.path) == names.end()) {
      throw ConfigError({"--set", 0}, unknownName("the parameter", setting.path, names));
    }
  }
  return parameters;
}

/// A sensor that follows the law of the default implementation.
/// @param settings values from --set, for the message
std::shared_ptr<Sensor> makeIdeal(const Registry::Entry& sampled, const Configuration& parameters,
                                  const std::vector<std::string>& settings) {
  auto sensor = makePlugin<Sensor>(sampled);
  auto* with_ideal = dynamic_cast<SampledSensor*>(sensor.get());
  if (with_ideal == nullptr) {
    throw ConfigError({"sample", 0}, "found the implementation 'sampled' of '" + sampled.description.label +
                                         "', which cannot read by the ideal law, allowed: those of the suite");
  }
  with_ideal->configureIdeal(parameters);
  if (with_ideal->hasErrors()) {
    throw ConfigError({"--set", 0}, "found '" + joinNames(settings) +
                                        "', by which readings have errors, allowed: parameters of the law, of which "
                                        "the table is");
  }
  return sensor;
}

/// @param given "": the robot that the device is made for
std::string robotOf(const std::string& device, const std::string& given) {
  const DeviceType* type = findDeviceType(device);
  std::string robot = given.empty() && type != nullptr ? type->robot : given;
  if (robot.empty()) {
    throw ConfigError({"--robot", 0}, "found none, allowed: a robot with the sensor '" + device + "'");
  }
  return robot;
}

ExitCode sample(const SampleOptions& options) {
  constexpr double kRadPerDeg = M_PI / 180.0;
  loadInstalledPlugins();
  const Registry::Entry& sampled = requireSampled(options.device);
  const std::string& device = sampled.description.label;
  const PluginDescription& ideal = Registry::instance().find(PluginKind::kSensor, device)->description;
  const std::string robot = robotOf(device, options.robot);
  SampleWorld world(makeIdeal(sampled, parametersOf(ideal, options.settings), options.settings), robot,
                    static_cast<std::size_t>(options.sensor));
  const std::vector<double> distances = distancesOf(world, options.distances);
  const std::vector<double> angles = anglesOf(world, options.angles);
  std::vector<Sample> samples;
  for (const double distance : distances) {
    for (const double angle : angles) {
      samples.push_back({distance, angle, world.read(distance, angle * kRadPerDeg)});
    }
  }
  const std::string text =
      sampleTableText(samples, device + " of a " + robot + ", sensor " + std::to_string(options.sensor) +
                                   ", implementation " + ideal.implementation + "; m, degrees, its own unit");
  OutFolder folder("", "--", {true, options.force});
  OutDescriptor file = folder.open(options.out, {"--out", {}, false});
  folder.keep();
  file.truncate(0);
  file.write(text.data(), text.size());
  return ExitCode::kFinished;
}

}  // namespace

Command addSampleCommand(CLI::App& app) {
  auto options = std::make_shared<SampleOptions>();
  CLI::App* command = app.add_subcommand("sample", "write a table of what a sensor reads by distance and angle");
  command->add_option("device", options->device, "its type, such as proximity")->required();
  command->add_option("--robot", options->robot, "that has the sensor; without it the one that it is made for");
  command->add_option("--out", options->out, "the CSV file")->required();
  command->add_option("--sensor", options->sensor, "which one of the device, from 0")->check(CLI::Range(0, 1000));
  command->add_option("--distances", options->distances, "FIRST:STEP:LAST [m]; else 20 steps as far as it reaches");
  command->add_option("--angles", options->angles, "FIRST:STEP:LAST [deg]; else 0:10:80, of light 0:10:90");
  command->add_option("--set", options->settings,
                      "name=value: a parameter of the law, not of errors (can be given again)");
  command->add_flag("--force", options->force, "replace a file that is there");
  return [options] { return sample(*options); };
}

}  // namespace swarmanoid::program

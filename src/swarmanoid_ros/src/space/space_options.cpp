#include "space_options.hpp"

#include <ros/node_handle.h>

#include <ctime>
#include <filesystem>

#include "swarmanoid_experiment_files/experiment_lookup.hpp"
#include "swarmanoid_experiment_files/override_text.hpp"
#include "swarmanoid_experiment_files/read_experiment.hpp"
#include "swarmanoid_hosts/ros/parameter_reader.hpp"
#include "swarmanoid_interface/contains.hpp"
#include "swarmanoid_space/models/limits.hpp"

namespace swarmanoid {
namespace {

std::string dateAndTime() {
  const std::time_t now = std::time(nullptr);
  std::tm local{};
  localtime_r(&now, &local);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%d-%H-%M-%S", &local);
  return text;
}

/// Returns the folder itself for an empty name.
std::string inFolder(const std::string& folder, const std::string& name) {
  return name.empty() ? folder : (std::filesystem::path(folder) / name).string();
}

}  // namespace

std::string readExitCodeFile(const ros::NodeHandle& own) {
  ParameterReader reader(own);
  const std::string file = reader.optional("exit_code");
  return file.empty() ? "" : inFolder(reader.text("folder", ""), file);
}

SpaceOptions readSpaceOptions(const ros::NodeHandle& own) {
  ParameterReader reader(own);
  SpaceOptions options;
  options.experiment = reader.text("experiment", "");
  if (options.experiment.empty()) {
    throw ConfigError(reader.location(),
                      "~experiment is not set, allowed: a file or the name of an installed "
                      "experiment: " +
                          joinNames(installedExperiments()));
  }
  options.seed = reader.count("seed", limits::kSeed);
  options.max_ticks = reader.count("max_ticks", limits::kTicks);
  const double factor = reader.number("real_time_factor", -1.0, {0.0, 1e6});
  if (factor >= 0.0) {
    if (!limits::isRealTimeFactor(factor)) {
      throw ConfigError(reader.location(),
                        "~real_time_factor: found " + numberText(factor) + ", allowed: " + limits::kRealTimeFactors);
    }
    options.real_time_factor = factor;
  }
  options.paused = reader.boolean("paused", false);
  options.record = reader.text("record", "");
  if (options.record == "false") {
    options.record.clear();
  } else if (options.record == "true") {
    options.record = dateAndTime() + ".bag";
  }
  options.record_controllers = reader.words("record_controllers");
  options.record_state = reader.boolean("record_state", false);
  options.hashes = reader.optional("hashes");
  options.save_interventions = reader.optional("save_interventions");
  options.interventions = reader.optional("interventions");
  options.folder = reader.text("folder", "");
  options.force = reader.boolean("force", false);
  options.write_anywhere = reader.boolean("write_anywhere", false);
  if (!options.interventions.empty()) {
    options.interventions = inFolder(options.folder, options.interventions);
  }
  options.out = inFolder(options.folder, reader.optional("out"));
  options.set = parseOverrides(reader.optional("set"), reader.location().file + ": ~set");
  reader.text("exit_code", "");  // marks the parameter as known; it is read elsewhere
  options.tf_level = parseTransformLevel(reader.choice("tf/level", {"auto", "none", "base", "full"}));
  options.tf_odometry = reader.boolean("tf/odometry", false) ? OdometryFrames::kShown : OdometryFrames::kHidden;
  options.tf_rate = reader.number("tf/rate", options.tf_rate, {0.0, 1e6});
  options.markers_rate = reader.number("markers/rate", options.markers_rate, {0.0, 1e6});
  options.world_state_rate = reader.number("world_state/rate", options.world_state_rate, {0.0, 1e6});
  options.clock_rate = reader.number("clock_rate", options.clock_rate, {1.0, 1000.0});
  options.device_topics = reader.words("device_topics");
  options.device_markers = reader.words("device_markers");
  options.stays_at_end = reader.choice("on_end", {"shutdown", "stay"}) == "stay";
  options.timeout = reader.number("timeout", options.timeout, {0.1, 3600.0});
  options.watchdog = reader.number("watchdog", options.watchdog, {0.0, 1e9});
  constexpr double kShortestWatchdog = 0.1;  // [s]; the watch checks five times a second
  if (options.watchdog > 0.0 && options.watchdog < kShortestWatchdog) {
    throw ConfigError(reader.location(), "~watchdog: found " + numberText(options.watchdog) +
                                             ", allowed: 0, or a number from 0.1 to 1000000000");
  }
  const Range waiting{0.001, 3600.0};
  options.lockstep.policy = *parseLatePolicy(reader.choice("lockstep/policy", {"wait", "skip", "stop"}));
  options.lockstep.timeout =
      Lockstep::Seconds(reader.number("lockstep/timeout", options.lockstep.timeout.count(), waiting));
  options.lockstep.join_timeout =
      Lockstep::Seconds(reader.number("lockstep/join_timeout", options.lockstep.join_timeout.count(), waiting));
  reader.refuseUnread({"engines", "controllers"});
  return options;
}

Experiment readExperiment(const SpaceOptions& options) {
  loadBuiltInPlugins();
  Experiment experiment = readExperiment(findExperiment(options.experiment), options.set);
  FrameworkDescription& framework = experiment.framework;
  framework.seed = options.seed.value_or(framework.seed);
  if (options.max_ticks) {
    framework.max_clock = *options.max_ticks;
    framework.location = {"~max_ticks", 0};
  }
  framework.real_time_factor = options.real_time_factor.value_or(framework.real_time_factor);
  return experiment;
}

std::vector<std::string> robotsWithTopics(const SpaceOptions& options, const Experiment& experiment) {
  std::vector<std::string> chosen = chooseRobots(options.device_topics, "~device_topics", experiment);
  for (const std::string& robot : robotNames(experiment, CommandSource::kTopics)) {
    if (!contains(chosen, robot)) {
      chosen.push_back(robot);
    }
  }
  return chosen;
}

}  // namespace swarmanoid

// `replay`: passes the readings of a bag to controllers, and compares their commands with the recorded ones.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <limits>

#include "read_bag.hpp"
#include "report.hpp"
#include "swarmanoid_interface/plugin_library.hpp"
#include "swarmanoid_interface/process/exit_code.hpp"
#include "swarmanoid_interface/process/math_library.hpp"
#include "swarmanoid_interface/process/user_code.hpp"

namespace swarmanoid::replay {
namespace {

struct Options {
  std::string bag;
  std::vector<std::string> robots;
  std::string controller;
  std::vector<std::string> parameters;
  TickRange range;
  bool print = false;
  bool log = false;
};

/// Loads the library of a controller if necessary. @return its label
std::string loadController(const std::string& asked, const std::string& recorded) {
  const Registry& registry = Registry::instance();
  std::string name = asked.empty() ? recorded : asked;
  std::error_code ignored;
  const auto slash = name.rfind('/');
  if (slash != std::string::npos && !std::filesystem::exists(name, ignored)) {
    name = name.substr(slash + 1);  // package/label, as in the name of a nodelet
  }
  if (registry.find(PluginKind::kController, name) != nullptr) {
    return name;
  }
  const std::vector<std::string> before = registry.labels(PluginKind::kController);
  const SourceLocation location{"--controller", 0};
  loadPluginLibrary(name, {}, location);
  std::vector<std::string> labels = registry.labels(PluginKind::kController);
  for (const std::string& label : {name, recorded}) {
    if (std::find(labels.begin(), labels.end(), label) != labels.end()) {
      return label;
    }
  }
  labels.erase(std::remove_if(labels.begin(), labels.end(),
                              [&](const std::string& label) {
                                return std::find(before.begin(), before.end(), label) != before.end();
                              }),
               labels.end());
  if (labels.size() != 1) {
    throw ConfigError(location, "library '" + name + "' has " +
                                    (labels.empty() ? "no controller" : "several controllers: " + joinNames(labels)) +
                                    "; allowed: one, or one with the recorded label '" + recorded + "'");
  }
  return labels.front();
}

bool replayRun(const RecordedRun& run, const std::string& title, const Options& options) {
  const std::string label = loadController(options.controller, run.robot().label);
  const Registry::Entry& entry = Registry::instance().require(PluginKind::kController, label);
  Robot::LogSink log;
  if (options.log) {
    log = [](LogLevel, const std::string& robot, const std::string& text) {
      std::cerr << robot << ": " << text << '\n';
    };
  }
  const Comparison comparison = compare(
      run, [&entry] { return makePlugin<Controller>(entry); }, log, options.range);
  std::cout << report(run, title, comparison) << std::flush;
  return comparison.equal == comparison.compared;
}

void refuseEmptyRange(const Recording& recording, TickRange range) {
  if (range.first > range.last) {
    throw ConfigError({"--from", 0}, "found " + std::to_string(range.first) + ", allowed: at most --to, " +
                                         std::to_string(range.last));
  }
  TickRange recorded{std::numeric_limits<std::uint64_t>::max(), 0};
  for (const auto& [robot, runs] : recording) {
    for (const RecordedRun& run : runs) {
      for (const RecordedTick& tick : run.ticks) {
        if (range.contains(tick.sensors.stamp.tick)) {
          return;
        }
        recorded.first = std::min(recorded.first, tick.sensors.stamp.tick);
        recorded.last = std::max(recorded.last, tick.sensors.stamp.tick);
      }
    }
  }
  throw ConfigError({"--from, --to", 0}, "found no tick in this range, allowed: " + std::to_string(recorded.first) +
                                             " to " + std::to_string(recorded.last));
}

int replay(const Options& options) {
  std::vector<ParameterValue> parameters;
  for (const std::string& word : options.parameters) {
    const std::vector<ParameterValue> values = readParameters(word);
    parameters.insert(parameters.end(), values.begin(), values.end());
  }
  const Recording recording = readBag(options.bag, options.robots, parameters);
  refuseEmptyRange(recording, options.range);
  std::cout << (options.print ? tableHeader() : "");
  bool are_equal = true;
  for (const auto& [robot, runs] : recording) {
    for (std::size_t i = 0; i < runs.size(); ++i) {
      const std::string title = titleOf(runs, i);
      std::cerr << warnings(runs[i], title);
      if (options.print) {
        std::cout << table(runs[i], options.range);
      } else {
        are_equal = replayRun(runs[i], title, options) && are_equal;
      }
    }
  }
  return toNumber(are_equal ? ExitCode::kFinished : ExitCode::kDiffers);
}

}  // namespace
}  // namespace swarmanoid::replay

int main(int argc, char** argv) {
  using namespace swarmanoid::replay;
  using swarmanoid::ExitCode;
  swarmanoid::fixMathLibrary(argv);  // the library of the run, if it was fixed there too
  Options options;
  CLI::App app{"Feeds controllers with the readings of a bag, and compares what they command with what was recorded.",
               "replay"};
  app.footer("Exit code: 0 all ticks are equal, 1 some differ, 2 bad input.");
  app.add_option("bag", options.bag, "with recorded controllers")->required();
  app.add_option("--robot", options.robots, "only this one (can be given again)")->allow_extra_args(false);
  app.add_option("--controller", options.controller, "another one: its label, or its library");
  app.add_option("--parameters", options.parameters,
                 "name=value, or a file of lines name: value: other parameters than the recorded ones (can be given "
                 "again)")
      ->allow_extra_args(false);
  app.add_option("--from", options.range.first, "first tick that is compared or printed")
      ->check(CLI::NonNegativeNumber);
  app.add_option("--to", options.range.last, "last tick")->check(CLI::NonNegativeNumber);
  app.add_flag("--print", options.print, "print what was recorded as a table, and replay nothing");
  app.add_flag("--log", options.log, "show what the controllers say");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return toNumber(app.exit(error) == 0 ? ExitCode::kFinished : ExitCode::kBadInput);
  }
  try {
    return replay(options);
  } catch (...) {
    std::cerr << "replay: " << swarmanoid::describeException() << '\n';
    return toNumber(ExitCode::kBadInput);
  }
}

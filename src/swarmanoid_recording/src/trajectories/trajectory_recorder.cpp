// Records poses of movable entities, readings and metrics as arrays in an HDF5 file.
#include <algorithm>
#include <filesystem>
#include <optional>
#include <sstream>

#include "swarmanoid_interface/contains.hpp"
#include "swarmanoid_interface/plain_text.hpp"
#include "swarmanoid_interface/process/math_library.hpp"
#include "swarmanoid_recording/output/out_file.hpp"
#include "swarmanoid_space/suite_version.hpp"
#include "trajectory_arrays.hpp"
#include "trajectory_file.hpp"

namespace swarmanoid {
namespace {

using trajectories::setAttribute;

/// Returns the sensor types of the experiment's robots, sorted.
std::vector<std::string> sensorsOf(const Experiment& experiment) {
  std::vector<std::string> types;
  for (const ControllerDescription& controller : experiment.controllers) {
    for (const DeviceDescription& sensor : controller.sensors) {
      if (!contains(types, sensor.type)) {
        types.push_back(sensor.type);
      }
    }
  }
  std::sort(types.begin(), types.end());
  return types;
}

/// @throws ConfigError
std::vector<std::string> chooseSensors(const std::string& text, const std::string& asked_by,
                                       const Experiment* experiment) {
  std::vector<std::string> there = experiment == nullptr ? std::vector<std::string>{} : sensorsOf(*experiment);
  std::vector<std::string> chosen;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    if (!contains(there, word) && word != "all" && word != "none") {
      throw ConfigError({}, asked_by + ": " + unknownName("the sensor", word, there) + ", or all, or none");
    }
    if (!contains(chosen, word)) {
      chosen.push_back(word);
    }
  }
  if (chosen == std::vector<std::string>{"all"}) {
    return there;
  }
  if (chosen == std::vector<std::string>{"none"}) {
    return {};
  }
  if (contains(chosen, "all") || contains(chosen, "none")) {
    throw ConfigError({}, asked_by + ": found '" + text + "', allowed: all alone, none alone, or names of sensors");
  }
  return chosen;
}

void describeExperiment(hid_t file, const Experiment& experiment) {
  std::vector<std::string> overrides;
  for (const Override& one : experiment.overrides) {
    overrides.push_back(one.path + "=" + one.value);
  }
  setAttribute(file, "experiment", experiment.name);
  setAttribute(file, "experiment_text", experiment.text);
  setAttribute(file, "overrides", overrides);
  setAttribute(file, "maxclock", std::uint64_t{experiment.framework.max_clock});
}

void describeOutcome(hid_t file, const RunOutcome& outcome) {
  setAttribute(file, "finished", outcome.is_finished);
  if (outcome.success) {
    setAttribute(file, "success", *outcome.success);
  }
  setAttribute(file, "failed_controllers", outcome.failed_robots);
  const trajectories::Hdf5Id group(H5Gcreate2(file, "result", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose,
                                   "making 'result'");
  for (const auto& [name, value] : outcome.metrics) {
    std::visit([&, &key = name](const auto& held) { setAttribute(group.get(), key, held); }, value);
  }
}

class TrajectoryRecorder final : public Observer {
 public:
  static PluginDescription describe() {
    using Type = Parameter::Type;
    PluginDescription description;
    description.label = "trajectory_recorder";
    description.summary =
        "Writes poses of all moving entities, readings and metrics of all ticks as arrays in an HDF5 file.";
    description.parameters = {
        makeParameter("file", Type::kText, "", std::nullopt, {}, "Output file."),
        makeParameter("every", Type::kInteger, "ticks", "1", {1.0, 1e9}, "Ticks from one row to the next."),
        makeParameter("readings", Type::kText, "", "none", {},
                      "Sensors whose readings are recorded: types, all or none.")};
    return description;
  }

  void configure(const std::string& id, const Configuration& parameters, const RunContext& context) override {
    id_ = id;
    context_ = context;
    every_ = static_cast<std::uint64_t>(parameters.integer("every", 1, {1.0, 1e9}));
    const std::string option = context.asked_by.empty() ? id + ": readings" : "--record-readings";
    devices_ = chooseSensors(parameters.text("readings", "none"), option, context.experiment);
    OutDescriptor file = openOutFile(context, parameters, id);
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(file.path(), ignored)) {
      throw ConfigError({context.asked_by, 0},
                        "found '" + file.path() +
                            "', which is a device or a pipe, allowed: a file, since trajectories "
                            "are read back while they are written");
    }
    file_.emplace(std::move(file));
  }

  void draw(const Space& space) override {
    if (space.tick % every_ == 0) {
      guard([&] {
        const bool is_first = !arrays_;
        begin(space);
        arrays_->append(space);
        space_ = &space;
        last_tick_ = space.tick;
        if (is_first || file_->wantsFlush()) {  // so that the file of a run that is killed early has its first state
          arrays_->write();
          file_->flush();
        }
      });
    }
  }

  void flush() override {
    guard([&] {
      if (arrays_) {
        arrays_->write();
        file_->flush();
      }
    });
  }

  void finish() override {
    flush();
    guard([&] {
      if (arrays_) {
        arrays_.reset();
        file_->complete([&](hid_t file) { describeEnd(file); });
      }
    });
  }

 private:
  void begin(const Space& space) {
    if (arrays_) {
      return;
    }
    file_->begin();
    const hid_t file = file_->id();
    setAttribute(file, "format", std::string("swarmanoid trajectories"));
    setAttribute(file, "format_version", std::uint64_t{1});
    setAttribute(file, "version", suiteVersion());
    setAttribute(file, "math_library", mathLibrary());
    setAttribute(file, "seed", std::uint64_t{space.seed});
    setAttribute(file, "clocktick", toSeconds(space.clocktick));
    setAttribute(file, "every", every_);
    if (context_.experiment != nullptr) {
      describeExperiment(file, *context_.experiment);
    }
    arrays_.emplace(file, devices_, space);
    file_->stream();
  }

  /// Writes the last attributes. The space still has the state of the last tick, because observers are completed first.
  void describeEnd(hid_t file) const {
    setAttribute(file, "ticks", space_->tick);
    if (space_->tick == last_tick_) {
      setAttribute(file, "state_hash", hashText(stateHash(*space_)));
    }
    if (context_.outcome) {
      describeOutcome(file, context_.outcome());
    }
  }

  /// Runs an action. The first exception is thrown; after it nothing is written.
  template <class Action>
  void guard(Action action) {
    if (is_lost_) {
      return;
    }
    try {
      action();
      file_->requireWritten();
    } catch (...) {
      is_lost_ = true;
      file_->requireWritten();  // throws the failed write that caused the exception, if any
      throw;
    }
  }

  RunContext context_;
  std::uint64_t every_ = 1;
  std::vector<std::string> devices_;
  std::optional<trajectories::TrajectoryFile> file_;
  std::optional<trajectories::TrajectoryArrays> arrays_;  // destroyed before the file is closed
  const Space* space_ = nullptr;
  std::uint64_t last_tick_ = 0;
  bool is_lost_ = false;
};

}  // namespace
}  // namespace swarmanoid

REGISTER_OBSERVER(swarmanoid::TrajectoryRecorder)

// Times in states: how long robots are in each of the states that their controllers report.
#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "listed_names.hpp"
#include "measuring_rule.hpp"

namespace swarmanoid::devices {
namespace {

class StateTimes final : public MeasuringRule {
 public:
  static PluginDescription describe() {
    using Type = Parameter::Type;
    PluginDescription description;
    description.label = "state_times";
    description.summary = "Measures for how long robots are in each state that their controllers say.";
    description.parameters = withParameters(
        {makeParameter("states", Type::kText, "", "", {}, "The debug values that are measured, separated by commas."),
         makeParameter("key", Type::kText, "", "state", {}, "Of these debug values.")});
    return description;
  }

 private:
  struct State {
    std::string name;
    Metric* time;
    std::size_t robots = 0;  // number of robots in it
  };

  void read(const Configuration& parameters) override {
    key_ = parameters.text("key");
    const Configuration& states = *parameters.find("states");
    location_ = states.location();
    for (const std::string& name : listedNames(states.text())) {
      const auto is_same = [&](const State& state) { return state.name == name; };
      if (name.empty() || name == kOther || std::any_of(states_.begin(), states_.end(), is_same)) {
        throw ConfigError(location_, "states: found '" + name + "', allowed: other names than '" + kOther +
                                         "', each once, separated by commas");
      }
      states_.push_back({name, &addMetric(name, "s", "Time in the state of this name.")});
    }
    other_ = &addMetric(kOther, "s", "Time in other states, or without a state.");
  }

  void archiveOwn(StateArchive& state) override { state(has_begun_); }

  void start(const Space&) override {
    if (states_.empty()) {
      throw ConfigError(location_, "states: found '', allowed: names, separated by commas");
    }
    has_begun_ = false;
  }

  void measure(const Space& space, bool) override {
    if (!has_begun_) {
      has_begun_ = true;
      return;  // no time has passed yet
    }
    const std::size_t robots = group().rows().size();
    std::size_t rest = robots;
    for (State& state : states_) {
      state.robots = 0;
    }
    for (const Row row : group().rows()) {
      if (State* state = stateOf(space.robots[row].get())) {
        ++state->robots;
        --rest;
      }
    }
    if (robots > 0) {
      const double time = static_cast<double>(every()) * toSeconds(space.clocktick) / static_cast<double>(robots);
      for (State& state : states_) {
        state.time->value += time * static_cast<double>(state.robots);
      }
      other_->value += time * static_cast<double>(rest);
    }
  }

  /// @param robot null: without a controller
  State* stateOf(const Robot* robot) {
    if (robot == nullptr) {
      return nullptr;
    }
    for (const auto& [key, value] : robot->debugValues()) {
      if (key == key_) {
        const auto found = std::find_if(states_.begin(), states_.end(),
                                        [&said = value](const State& state) { return state.name == said; });
        return found == states_.end() ? nullptr : &*found;
      }
    }
    return nullptr;
  }

  static constexpr const char* kOther = "other";

  std::string key_;
  SourceLocation location_;
  std::vector<State> states_;
  bool has_begun_ = false;
  Metric* other_ = nullptr;
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_RULE(swarmanoid::devices::StateTimes)

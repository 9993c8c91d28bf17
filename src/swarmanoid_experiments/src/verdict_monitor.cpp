// Judges experiments whose robots report a verdict as a debug value: the run ends when no verdict is undecided, and is
// a success if all are good.
#include <algorithm>
#include <map>
#include <set>
#include <string>

#include "swarmanoid_space/observer.hpp"

namespace swarmanoid {

class VerdictMonitor final : public Observer {
 public:
  static PluginDescription describe() {
    PluginDescription description;
    description.label = "verdict_monitor";
    description.summary = "Ends the run when all robots with a verdict have given it, and reports their verdicts.";
    using Type = Parameter::Type;
    description.parameters = {
        makeParameter("key", Type::kText, "", "conformance", {}, "The debug value that is a robot's verdict."),
        makeParameter("good", Type::kText, "", "passed", {}, "The verdict of a success."),
        makeParameter("undecided", Type::kText, "", "running", {}, "What a robot says before.")};
    return description;
  }

  void configure(const std::string& id, const Configuration& parameters, const RunContext&) override {
    id_ = id;
    key_ = parameters.text("key", "conformance");
    good_ = parameters.text("good", "passed");
    undecided_ = parameters.text("undecided", "running");
  }

  void draw(const Space& space) override {
    for (const Row row : space.entities.order) {
      if (space.robots[row] == nullptr || failed_.count(space.entities.name[row]) > 0) {
        continue;
      }
      for (const auto& [key, value] : space.robots[row]->debugValues()) {
        if (key == key_) {
          verdicts_[space.entities.name[row]] = value;
        }
      }
    }
    // other processes do not send the debug value that a controller sets when it fails, but they send the failure's
    // reason
    for (const Event& event : space.events) {
      if (event.kind == Event::Kind::kControllerFailed && verdicts_.count(event.entity) > 0) {
        verdicts_[event.entity] = event.text;
        failed_.insert(event.entity);
      }
    }
  }

  bool terminate() const override {
    return !verdicts_.empty() && std::none_of(verdicts_.begin(), verdicts_.end(),
                                              [&](const auto& verdict) { return verdict.second == undecided_; });
  }
  std::optional<bool> success() const override {
    return !verdicts_.empty() && std::all_of(verdicts_.begin(), verdicts_.end(),
                                             [&](const auto& verdict) { return verdict.second == good_; });
  }
  void addMetrics(Metrics& metrics) const override {
    for (const auto& [robot, verdict] : verdicts_) {
      metrics[robot] = verdict;
    }
  }
  void reset() override {
    verdicts_.clear();
    failed_.clear();
  }

 private:
  std::string key_;
  std::string good_;
  std::string undecided_;
  std::map<std::string, std::string> verdicts_;  // verdicts by robot
  std::set<std::string> failed_;                 // robots whose verdict is the reason of their failure
};

}  // namespace swarmanoid

REGISTER_OBSERVER(swarmanoid::VerdictMonitor)

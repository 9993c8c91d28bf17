/// Rules scripted by a test, and a list of all calls in a run.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "swarmanoid_experiment_files/read_experiment.hpp"
#include "swarmanoid_interface/controller.hpp"
#include "swarmanoid_space/rule.hpp"
#include "swarmanoid_space/simulation/simulation.hpp"

namespace swarmanoid::test {

class ScriptedRule;
using Hook = std::function<void(ScriptedRule&, const Space&, InterventionQueue&)>;

/// Actions of one rule.
struct Script {
  Hook reset;
  Hook before;
  Hook after;
  bool is_finished = false;
  std::optional<bool> success;
};

/// Scripts of all rules in this process, by id.
inline std::map<std::string, Script>& scripts() {
  static std::map<std::string, Script> all;
  return all;
}

/// Calls so far, "a.before", "step", "draw", ... in their order.
inline std::vector<std::string>& calls() {
  static std::vector<std::string> all;
  return all;
}

class ScriptedRule final : public Rule {
 public:
  static PluginDescription describe() {
    PluginDescription description;
    description.label = "scripted_rule";
    return description;
  }

  void configure(const Configuration&) override {
    note("configure");
    count = &addMetric("count", "1", "What the test counts.");
  }
  void reset(const Space& space, InterventionQueue& queue) override { call("reset", script().reset, space, queue); }
  void beforeTick(const Space& space, InterventionQueue& queue) override {
    call("before", script().before, space, queue);
  }
  void afterTick(const Space& space, InterventionQueue& queue) override { call("after", script().after, space, queue); }
  bool isFinished() const override { return script().is_finished; }
  std::optional<bool> success() const override { return script().success; }

  double draw() { return random().uniform(); }
  std::size_t below(std::size_t number) { return random().below(number); }

  Metric* count = nullptr;

 private:
  Script& script() const { return scripts()[id()]; }
  void note(const char* hook) const { calls().push_back(id() + "." + hook); }
  void call(const char* name, const Hook& hook, const Space& space, InterventionQueue& queue) {
    note(name);
    if (hook) {
      hook(*this, space, queue);
    }
  }
};

class NotingController final : public Controller {
 public:
  void init(Robot&, const Configuration&) override {}
  void step(Time, Duration) override { calls().emplace_back("step"); }
};

class NotingObserver final : public Observer {
 public:
  explicit NotingObserver(std::optional<bool> success = std::nullopt) : success_(success) { id_ = "noting"; }
  void configure(const std::string&, const Configuration&, const RunContext&) override {}
  void draw(const Space&) override { calls().emplace_back("draw"); }
  std::optional<bool> success() const override { return success_; }

 private:
  std::optional<bool> success_;
};

/// A footbot "fb" with a controller at (1, 2), a prey, a nest, no engine, and the rules `a` and `b`, which run their
/// `scripts`.
inline std::unique_ptr<Simulation> ruledWorld(std::uint64_t seed = 1, SuppliedParts supplied = {}) {
  Experiment experiment = parseExperiment(R"(
<ahss-config>
  <framework><clocktick>100</clocktick><maxclock>100</maxclock></framework>
  <controllers><noting_controller id="nc"/></controllers>
  <arena size="5,5,3" optimization="2D">
    <footbot id="fb"><position>1, 2, 0</position><orientation>0, 0, 0</orientation><controller>nc</controller></footbot>
    <cylindric_prey id="prey"><position>3, 1, 0</position><orientation>0, 0, 0</orientation>
      <radius>0.06</radius><height>0.1</height></cylindric_prey>
  </arena>
  <rules><scripted_rule id="a"/><scripted_rule id="b"/></rules>
</ahss-config>)",
                                          "rules.xml");
  experiment.framework.seed = seed;
  return std::make_unique<Simulation>(std::move(experiment), RunContext{}, std::move(supplied));
}

inline Intervention moveTo(double x, double y) {
  return MoveEntity{"fb", {{x, y, 0.0}, Eigen::Quaterniond::Identity()}};
}

inline double xOf(const Space& space, const std::string& name = "fb") {
  return space.entities.pose[space.entities.find(name)].position.x();
}

inline std::string eventsOf(const Simulation& simulation) {
  std::string text;
  for (const Event& event : simulation.space().events) {
    text +=
        std::string(toString(event.kind)) + " " + event.entity + (event.text.empty() ? "" : ": " + event.text) + ";";
  }
  return text;
}

}  // namespace swarmanoid::test

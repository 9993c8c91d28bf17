/// The base class of rules: plugins that act on the world beside robots and engines. Examples: charging stations, lamps
/// that switch, preys that return, walls that move, and the scoring of a run (thesis 4.1.1: the user's own main;
/// elsewhere "loop functions").
///
/// Phases   reset: before the first tick, and after each reset of the run. beforeTick: before `sense`. afterTick: phase
///          `rule`, after `index` and before `show`. All on the simulation's thread; rules in the order of the file.
/// World    a rule has const access to the space, and changes it only by interventions, which are carried out between
///          ticks. Interventions that reset and beforeTick request are carried out right after the call, in order,
///          before the next rule is called; those that afterTick requests are carried out before the next tick.
/// Errors   an exception of a hook ends the run, results are kept; so does the refusal of an intervention that was
///          requested by InterventionQueue::ask.
/// Repeats  a rule draws from random() and keeps no state across a reset, so that runs can be reproduced.
///
/// To add one: derive, end with REGISTER_RULE; docs/how-to/add_a_rule_or_visualisation.md.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <string>

#include "swarmanoid_interface/configuration.hpp"
#include "swarmanoid_interface/expects.hpp"
#include "swarmanoid_interface/random.hpp"
#include "swarmanoid_interface/registry.hpp"
#include "swarmanoid_interface/state_archive.hpp"
#include "swarmanoid_space/intervention_queue.hpp"
#include "swarmanoid_space/metrics.hpp"
#include "swarmanoid_space/space.hpp"

namespace swarmanoid {

class Rule {
 public:
  virtual ~Rule() = default;

  /// Called once, before all other functions. Metrics are added here. @throws ConfigError
  virtual void configure(const Configuration& parameters) = 0;

  /// Called when the run begins: the entities of the file exist, and no tick was made. Resets all state of the rule.
  virtual void reset(const Space&, InterventionQueue&) {}
  virtual void beforeTick(const Space&, InterventionQueue&) {}
  virtual void afterTick(const Space&, InterventionQueue&) {}

  /// Whether the run should end before maxclock. Called after each tick.
  virtual bool isFinished() const { return false; }
  /// Whether the run was a success; only some rules judge that.
  virtual std::optional<bool> success() const { return std::nullopt; }

  /// Saves or loads all own state that follows neither from the parameters nor from the space (state_archive.hpp), for
  /// snapshots of a run. Metrics and random numbers are saved for it. A rule without such state overrides it with an
  /// empty function. The default declares that the state is not defined: a snapshot is then refused, with the rule's
  /// name.
  virtual void archive(StateArchive& state) { state.refuse(); }

  const std::string& id() const { return id_; }
  /// In the order in which they were added.
  const std::deque<Metric>& metrics() const { return metrics_; }

  // For the simulation.
  void setId(const std::string& id) { id_ = id; }
  /// Resets metrics and random numbers.
  void begin(std::uint64_t seed) {
    random_ = RandomStream(seed, id_, "rule");
    random_.startTick(~std::uint64_t{0});  // not the number of any tick, so the first tick has draws of its own
    for (Metric& metric : metrics_) {
      metric.value = 0.0;
    }
  }
  void startTick(std::uint64_t tick) { random_.startTick(tick); }
  /// `archive`, with metrics and random numbers.
  void archiveAll(StateArchive& state) {
    state(random_);
    for (Metric& metric : metrics_) {
      state(metric.value);
    }
    archive(state);
  }
  /// Later ticks draw with another seed.
  void reseed(std::uint64_t seed) { random_.reseed(seed); }

 protected:
  /// The random numbers of this rule. Each tick has its own sequence, independent of other draws.
  RandomStream& random() { return random_; }

  /// Adds a metric; call it in `configure`. The rule sets `value`, which is 0 when a run begins.
  /// @param name unique in this rule @return a reference that stays valid
  Metric& addMetric(const std::string& name, const std::string& unit, const std::string& description) {
    SWARMANOID_EXPECTS(!id_.empty());
    return metrics_.emplace_back(Metric{id_ + "." + name, unit, description, 0.0});
  }

 private:
  std::string id_;
  RandomStream random_;
  std::deque<Metric> metrics_;
};

}  // namespace swarmanoid

/// Registers a rule; place it at the end of the source. `Class` has a static function `PluginDescription describe()`.
#define REGISTER_RULE(Class)                                                                \
  namespace {                                                                               \
  const ::swarmanoid::PluginRegistration<::swarmanoid::Rule, Class> SWARMANOID_CONCATENATE( \
      registration_, __COUNTER__)(::swarmanoid::PluginKind::kRule, Class::describe());      \
  }

/// The base class of rules: plugins that act on the world beside robots and engines. Stations that charge, lamps that
/// switch, prey that comes back, walls that move, and what judges and scores a run (thesis 4.1.1: the user's own main;
/// elsewhere "loop functions").
///
/// Phases   reset: before the first tick, and after each reset of the run. beforeTick: before `sense`. afterTick: phase
///          `rule`, after `index` and before `show`. All on the simulation's thread; rules in the order of the file.
/// World    a rule sees the space const, and changes it only by interventions, which are carried out between ticks:
///          those that reset and beforeTick ask for right after the call, in order, before the next rule is called;
///          those that afterTick asks for before the next tick.
/// Errors   what a hook throws ends the run, results kept; so does an intervention that was asked for and is refused.
/// Bits     a rule draws from random(), and keeps nothing from the run before a reset: then runs can be had again.
///
/// To add one: derive, end with REGISTER_RULE; docs/how-to/add_a_rule.md.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <string>

#include "swarmanoid_interface/configuration.hpp"
#include "swarmanoid_interface/expects.hpp"
#include "swarmanoid_interface/random.hpp"
#include "swarmanoid_interface/registry.hpp"
#include "swarmanoid_space/intervention_queue.hpp"
#include "swarmanoid_space/metrics.hpp"
#include "swarmanoid_space/space.hpp"

namespace swarmanoid {

class Rule {
 public:
  virtual ~Rule() = default;

  /// Once, before everything. Metrics are added here. @throws ConfigError
  virtual void configure(const Configuration& parameters) = 0;

  /// The run begins: the entities of the file are there, and no tick was made. Whatever the rule keeps starts anew.
  virtual void reset(const Space&, InterventionQueue&) {}
  virtual void beforeTick(const Space&, InterventionQueue&) {}
  virtual void afterTick(const Space&, InterventionQueue&) {}

  /// Whether the run should end before maxclock. Asked after each tick.
  virtual bool isFinished() const { return false; }
  /// Whether the run was a success; only some rules judge that.
  virtual std::optional<bool> success() const { return std::nullopt; }

  const std::string& id() const { return id_; }
  /// In the order in which they were added.
  const std::deque<Metric>& metrics() const { return metrics_; }

  // For the simulation.
  void setId(const std::string& id) { id_ = id; }
  /// Metrics and random numbers start anew.
  void begin(std::uint64_t seed) {
    random_ = RandomStream(seed, id_, "rule");
    random_.startTick(~std::uint64_t{0});  // which no tick is: the first has draws of its own
    for (Metric& metric : metrics_) {
      metric.value = 0.0;
    }
  }
  void startTick(std::uint64_t tick) { random_.startTick(tick); }
  /// The ticks from now on draw with another seed.
  void reseed(std::uint64_t seed) { random_.reseed(seed); }

 protected:
  /// Numbers of this rule alone; each tick has its own, which do not depend on the draws of others.
  RandomStream& random() { return random_; }

  /// In `configure`. The rule sets `value`, which is 0 when a run begins. @return stays where it is
  /// @param name unique in this rule
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

/// At the end of a rule's source. `Class` has a static function `PluginDescription describe()`.
#define REGISTER_RULE(Class)                                                                \
  namespace {                                                                               \
  const ::swarmanoid::PluginRegistration<::swarmanoid::Rule, Class> SWARMANOID_CONCATENATE( \
      registration_, __COUNTER__)(::swarmanoid::PluginKind::kRule, Class::describe());      \
  }

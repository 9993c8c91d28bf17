/// The base class of observers: plugins that draw, write, record, measure or judge a run. Experiment files and the
/// thesis (3.6) call them visualisations.
///
/// Phase   draw: `show`, once before the first tick and after each tick, on the simulation's thread.
/// An observer has const access to the space and changes nothing in it, so it does not change the run.
///
/// An observer that writes text has an OutFile (out_file.hpp). Observers with a parameter `file`, or with a true
/// parameter that begins with `write_`, write files: Python and batches omit them in runs without a folder.
///
/// To add one: derive, end with REGISTER_OBSERVER.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "swarmanoid_interface/configuration.hpp"
#include "swarmanoid_interface/registry.hpp"
#include "swarmanoid_space/metrics.hpp"
#include "swarmanoid_space/space.hpp"

namespace swarmanoid {

class OutFolder;

/// The outcome of a run.
struct RunOutcome {
  bool is_finished = false;  ///< reached its end; false: was stopped
  std::optional<bool> success;
  Metrics metrics;
  std::vector<std::string> failed_robots;  ///< robots whose controllers failed
};

/// The context of an observer's run.
struct RunContext {
  std::shared_ptr<OutFolder> out;  ///< decides which files may be written, for OutFile; null: any
  std::string asked_by;            ///< the option that requests the observer, "--bag"; "": the experiment file
  bool headless = true;
  bool is_open = true;       ///< other processes can command robots, over topics or as lockstep participants
  bool keeps_start = false;  ///< keep the state before the first tick, so that resets are fast, for small worlds
  bool is_fork = false;      ///< the seed will change during the run: a record could not reproduce it
  const Experiment* experiment = nullptr;
  std::function<RunOutcome()> outcome;  ///< for `finish` of observers; empty: not known
};

class Observer {
 public:
  virtual ~Observer() = default;

  /// @throws ConfigError
  virtual void configure(const std::string& id, const Configuration& parameters, const RunContext& context) = 0;

  /// Displays the state of the space. @throws std::exception: the run stops, results are kept
  virtual void draw(const Space& space) = 0;

  /// Whether the run should end before maxclock (thesis 3.6, Terminate). Called after each draw.
  virtual bool terminate() const { return false; }

  /// Whether the run was a success; only some observers judge that.
  virtual std::optional<bool> success() const { return std::nullopt; }
  virtual void addMetrics(Metrics&) const {}

  /// Hands all written data to the operating system, so that it survives the end of this process. Called once a second
  /// of wall time, and when the run is paused. @throws std::exception (a full disk): the run stops, results are kept
  virtual void flush() {}
  /// Called after the run was reset to its start; the next draw shows tick 0.
  virtual void reset() {}
  /// Called when the run is over; completes files.
  virtual void finish() {}

  const std::string& id() const { return id_; }

 protected:
  std::string id_;
};

}  // namespace swarmanoid

/// Registers an observer; place it at the end of the source. `Class` has a static function
/// `PluginDescription describe()`.
#define REGISTER_OBSERVER(Class)                                                                \
  namespace {                                                                                   \
  const ::swarmanoid::PluginRegistration<::swarmanoid::Observer, Class> SWARMANOID_CONCATENATE( \
      registration_, __COUNTER__)(::swarmanoid::PluginKind::kObserver, Class::describe());      \
  }

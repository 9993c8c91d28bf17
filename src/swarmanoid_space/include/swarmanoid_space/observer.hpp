/// The base class of observers: plugins that look at a run and draw, write, record, measure or judge it. Experiment
/// files and the thesis (3.6) call them visualisations.
///
/// Phase   draw: `show`, once before the first tick and after each tick, on the simulation's thread.
/// An observer sees the space const and changes nothing in it, so a run with it and one without are the same.
///
/// One that writes a text has an OutFile (out_file.hpp). Those that have a parameter `file`, or one that begins with
/// `write_` and is true, write files: Python and batches leave them out of runs that have no folder.
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

/// What has come of a run, when it is over.
struct RunOutcome {
  bool is_finished = false;  ///< it came to its end; false: it was stopped
  std::optional<bool> success;
  Metrics metrics;
  std::vector<std::string> failed_robots;  ///< whose controllers failed
};

/// The run that an observer looks at.
struct RunContext {
  std::shared_ptr<OutFolder> out;  ///< which files may be written, for OutFile; null: any
  std::string asked_by;            ///< the option that asks for the observer, "--bag"; "": the experiment file
  bool headless = true;
  bool is_open = true;   ///< other processes can command robots, over topics or as participants of lockstep
  bool is_fork = false;  ///< the seed will change in the middle: a record of the run could not be made again
  const Experiment* experiment = nullptr;
  std::function<RunOutcome()> outcome;  ///< for `finish` of observers; empty: it is not known
};

class Observer {
 public:
  virtual ~Observer() = default;

  /// @throws ConfigError
  virtual void configure(const std::string& id, const Configuration& parameters, const RunContext& context) = 0;

  /// Displays the state of the space. @throws std::exception: the run stops, results kept
  virtual void draw(const Space& space) = 0;

  /// Whether the run should end before maxclock (thesis 3.6, Terminate). Asked after each draw.
  virtual bool terminate() const { return false; }

  /// Whether the run was a success; only some observers judge that.
  virtual std::optional<bool> success() const { return std::nullopt; }
  virtual void addMetrics(Metrics&) const {}

  /// What was written so far goes to the system, which keeps it if this process is killed. Called once a second of wall
  /// time, and when the run is paused. @throws std::exception (a full disk): the run stops, results kept
  virtual void flush() {}
  /// The run is put back to its start; the next draw shows tick 0.
  virtual void reset() {}
  /// The run is over; files are completed.
  virtual void finish() {}

  const std::string& id() const { return id_; }

 protected:
  std::string id_;
};

}  // namespace swarmanoid

/// At the end of an observer's source. `Class` has a static function `PluginDescription describe()`.
#define REGISTER_OBSERVER(Class)                                                                \
  namespace {                                                                                   \
  const ::swarmanoid::PluginRegistration<::swarmanoid::Observer, Class> SWARMANOID_CONCATENATE( \
      registration_, __COUNTER__)(::swarmanoid::PluginKind::kObserver, Class::describe());      \
  }

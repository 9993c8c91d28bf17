/// A running experiment: the space, and all that acts on it.
///
/// Threads  all functions from one thread (the space's), unless they say otherwise.
/// ROS      is not known here: the space nodelet and the command-line program both hold one of these.
#pragma once

#include <chrono>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "swarmanoid_interface/command_mailbox.hpp"
#include "swarmanoid_interface/controller.hpp"
#include "swarmanoid_space/engine.hpp"
#include "swarmanoid_space/experiment_file/experiment.hpp"
#include "swarmanoid_space/observer.hpp"
#include "swarmanoid_space/space.hpp"

namespace swarmanoid {

/// Wall time spent in each phase of the last tick [s]; the names are those of the files in src/phases/.
struct PhaseTimes {
  double sense = 0.0;
  double control = 0.0;
  double actuate = 0.0;
  double move = 0.0;
  double connect = 0.0;  ///< and handover
  double index = 0.0;
  double show = 0.0;
  std::vector<double> engines;  ///< of `move`: each engine by itself, in the order of Space::engines

  PhaseTimes& operator+=(const PhaseTimes& other);
};

/// Names of parameters, and values as they would stand in the experiment file.
using NamedValues = std::vector<std::pair<std::string, std::string>>;

/// A robot whose controller threw in a step (or in destroy), or commanded a number that is not finite.
struct ControllerFailure {
  std::string robot;
  std::uint64_t tick = 0;
  std::string reason;
};

/// What may be supplied from outside instead of being made from the registry, by id: the nodelets do so.
struct SuppliedParts {
  std::map<std::string, std::shared_ptr<Engine>> engines;  ///< already configured
  std::map<std::string, std::function<std::shared_ptr<Controller>()>> controllers;
  std::shared_ptr<CommandMailbox> commands;  ///< for robots commanded over topics; null: there are none
};

/// The state of an engine, for diagnostics.
struct EngineReport {
  std::string id;
  std::string label;
  std::size_t moved = 0;     ///< entities that it moves
  std::size_t mirrored = 0;  ///< entities that it keeps a mirror of
  EngineHealth health;
};

class Lockstep;
struct Assembly;
struct Membership;
struct RobotInstance;

class Simulation {
 public:
  /// Builds the experiment up to its state before tick 0.
  /// @throws ConfigError
  explicit Simulation(Experiment experiment, RunContext context = {}, SuppliedParts supplied = {});
  ~Simulation();
  Simulation(const Simulation&) = delete;
  Simulation& operator=(const Simulation&) = delete;

  /// Shows the state before the first tick. Call once, before tick().
  void start();
  /// One tick (thesis 3.1), phases in the order of PhaseTimes. Does nothing once finished.
  /// @param is_disturbed while the tick waits for participants, and at each `wake`: whether an action on
  /// the simulation waits for the end of the tick
  /// @return false: it was disturbed and given up before anything happened; it is to be made again, after that
  bool tick(const std::function<bool()>& is_disturbed = nullptr);
  /// maxclock is reached, or an observer asked to finish.
  bool isFinished() const;
  /// What observers have written goes to the system: a process that is killed loses nothing of it. A tick does so
  /// once a second of wall time; for callers that make none for some time. @throws what observers throw
  void flush();
  /// Destroys all controllers: what they throw now is in failures() too. For callers that read these;
  /// the destructor does it otherwise. Afterwards there are no ticks.
  void destroyControllers();
  /// Completes what observers write, all of them. Called by the destructor if it was not.
  /// @throws what the first observer that fails throws
  void finish();

  /// A call of the plugin that is called so (UserCode::part) does not return. An observer is called no more, by
  /// `finish`, `metrics` and `success`, which the others do not miss. For a caller that ends the process then.
  void giveUp(const std::string& part);

  const Experiment& experiment() const { return experiment_; }
  const Space& space() const { return space_; }
  const PhaseTimes& phaseTimes() const { return phase_times_; }
  const std::vector<ControllerFailure>& failures() const { return failures_; }
  /// Robots that have a controller.
  std::size_t robotCount() const;
  std::uint64_t stateHash() const { return swarmanoid::stateHash(space_); }
  Metrics metrics() const;
  /// In the order of Space::engines. Allocates.
  std::vector<EngineReport> engineReports() const;
  /// The values that an engine works with: those of the file, and what was set since.
  /// @throws ConfigError if there is no such engine
  const Configuration& engineParameters(const std::string& engine) const;
  /// What the observers that judge it agree on; nothing if none judges.
  std::optional<bool> success() const;

  /// For code that carries frames between this simulation and participants.
  Lockstep& lockstep();
  /// A tick that waits for participants ends with an exception; later ticks do not wait. From any thread.
  void interrupt();
  /// A tick that waits for participants asks again whether it is disturbed. From any thread.
  void wake();

  /// One more observer of the run. Before start(), or between ticks.
  void addObserver(std::shared_ptr<Observer> observer);

  /// Where robots' logs go; by default nowhere.
  void setLogSink(Robot::LogSink sink);

  // Interventions: between ticks; they take effect at once and are events of the next tick.

  /// Adds an entity to the engines named (the first moves it).
  /// @throws ConfigError (bad place, overlap, unknown name, a controller for other robots); then nothing has changed
  void spawn(const EntityDescription& entity, const std::vector<std::string>& engines);
  /// @throws ConfigError if there is no such entity
  void remove(const std::string& name);
  /// @throws ConfigError (unknown name, bad place, overlap); then nothing has changed
  void move(const std::string& name, const Pose& pose);
  /// Another engine moves the entity from now on, and all that is connected to it: poses, twists, grips, devices,
  /// commands and readings stay as they are. An engine that gives an entity up keeps a mirror of it if the experiment
  /// file (or whoever spawned it) lists the entity there. Nothing happens if that engine moves it already.
  /// @throws ConfigError (unknown name, or one of them is fixed, misplaced, in the way of something else or beyond what
  /// the engine can simulate); then nothing has changed
  void handover(const std::string& name, const std::string& engine);
  /// Gives parameters of an engine new values, as they would stand in the experiment file. The engine works with them
  /// from the next tick on. What is given the value that it has changes nothing and is no event.
  /// @throws ConfigError (unknown engine or parameter, one that is not live, a bad value); then nothing has changed
  void setEngineParameters(const std::string& engine, const NamedValues& values);
  /// Another source commands the robot from now on. A controller in this process starts anew; a robot that nobody
  /// commands stops, one that is commanded over topics until the first command comes; one whose commands come from
  /// elsewhere keeps the last ones until a participant answers.
  /// @throws ConfigError (no such robot, a controller that does not start, a device that cannot travel); then nothing
  /// has changed
  void setCommandSource(const std::string& robot, CommandSource source);
  /// Back to the state before tick 0: spawned, deleted and handed over entities included, and parameters of engines as
  /// in the file. `seed` replaces the experiment's if given. Space::time_before_reset grows so that ROS time keeps
  /// rising, unless `rewind` sets it back to 0.
  void reset(std::optional<std::uint64_t> seed = std::nullopt, bool rewind = false);

 private:
  void build();
  void buildEngines();
  void buildControllerGroups();
  void buildEntities();
  void buildBoundary();
  void buildTriggers();
  void distribute(const EntityDescription& group, const std::vector<Membership>& memberships);
  void noteFailures();
  void logNewOverflows();
  void unbuild();
  void restoreEngineParameters();
  /// Its place in the experiment. @throws ConfigError if there is none
  std::size_t engineIndex(const std::string& id) const;
  void refuseBadPlace(const EntityDescription& entity, const EntityModel& model, const Pose& pose,
                      const std::vector<Membership>& memberships) const;
  Row addEntity(const EntityDescription& entity, const std::vector<Membership>& memberships);
  void giveController(Row row, const EntityDescription& entity);
  void destroyController(RobotInstance& instance);
  void removeEntity(Row row);
  void refuseUnlessReachable(const RobotInstance& instance, CommandSource source) const;
  void offerRobots();

  Experiment experiment_;
  RunContext context_;
  SuppliedParts supplied_;
  Space space_;
  std::unique_ptr<Assembly> assembly_;            // engines, robots, observers
  std::unique_ptr<Lockstep> lockstep_;            // commands from other processes
  std::vector<Row> faulty_;                       // scratch of `actuate`
  std::vector<Configuration> engine_parameters_;  // as of now, in the order of Space::engines
  PhaseTimes phase_times_;
  std::vector<ControllerFailure> failures_;
  std::size_t logged_overflows_ = 0;
  std::vector<Event> pending_events_;
  Robot::LogSink log_sink_;
  std::chrono::steady_clock::time_point next_flush_;
  bool is_started_ = false;
  bool finish_asked_ = false;
  bool finished_ = false;
};

}  // namespace swarmanoid

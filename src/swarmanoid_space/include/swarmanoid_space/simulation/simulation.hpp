/// A running experiment: the space, and all objects that act on it.
///
/// Threads  all functions from one thread (the space's), unless stated otherwise.
/// ROS      not used here: the space nodelet and the command-line program both own one of these.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "swarmanoid_space/experiment/experiment.hpp"
#include "swarmanoid_space/intervention.hpp"
#include "swarmanoid_space/observer.hpp"
#include "swarmanoid_space/simulation/intervention_player.hpp"
#include "swarmanoid_space/snapshot/snapshot.hpp"
#include "swarmanoid_space/space.hpp"
#include "swarmanoid_space/world/controller_failure.hpp"
#include "swarmanoid_space/world/engine_report.hpp"
#include "swarmanoid_space/world/supplied_parts.hpp"

namespace swarmanoid {

/// Wall time spent in each phase of a tick [s]; the names are those of the files in src/phases/.
struct PhaseTimes {
  double sense = 0.0;
  double control = 0.0;
  double actuate = 0.0;
  double move = 0.0;
  double connect = 0.0;  ///< includes handover, and falling into holes
  double index = 0.0;
  double power = 0.0;
  double rule = 0.0;  ///< includes the rules' work before the tick
  double show = 0.0;
  std::vector<double> engines;  ///< share of `move` per engine, in the order of Space::engines

  PhaseTimes& operator+=(const PhaseTimes& other);
};

/// The command source of a robot, and whether its controller has failed since the robot was added.
struct ControllerStatus {
  CommandSource source = CommandSource::kController;
  bool has_failed = false;
};

class DeviceDrawings;
class Lockstep;
struct World;

class Simulation {
 public:
  /// Builds the experiment up to its state before tick 0.
  /// @throws ConfigError
  explicit Simulation(Experiment experiment, RunContext context = {}, SuppliedParts supplied = {});
  ~Simulation();
  Simulation(const Simulation&) = delete;
  Simulation& operator=(const Simulation&) = delete;

  /// Displays the state before the first tick. Call once, before tick().
  void start();
  /// Makes one tick (thesis 3.1), phases in the order of PhaseTimes. Does nothing once finished.
  /// @param is_disturbed called while the tick waits for participants, and at each `wake`: whether an action on the
  /// simulation waits for the end of the tick
  /// @return false: the tick was given up before anything changed; call it again after that action
  bool tick(const std::function<bool()>& is_disturbed = nullptr);
  /// Between ticks: runs the beginning of the next tick (rules before the tick, and `sense`) now, so that readings are
  /// those that its controllers will get. For callers that decide the robots' commands outside controllers. Does
  /// nothing once finished. @throws exceptions of rules
  void sense();
  /// Whether maxclock is reached, or a rule or an observer has requested the end, or `finish` was called.
  bool isFinished() const;
  /// The same, but false for a run that `finish` has ended early.
  bool hasReachedEnd() const;
  /// Hands the output of observers to the operating system, so that it survives the end of the process. A tick does
  /// this once a second of wall time; for callers that make no ticks for some time. @throws exceptions of observers
  void flush();
  /// Destroys all controllers, so that failures() includes their exceptions; for callers that read these. The
  /// destructor does it otherwise. No ticks afterwards.
  void destroyControllers();
  /// Completes the output of all observers. Called by the destructor if necessary.
  /// @throws the exception of the first observer that fails
  void finish();

  /// Declares that a call of the plugin of this name (UserCode::part) does not return. `finish`, `metrics` and
  /// `success` no longer call such an observer, and still call the others. For a caller that then ends the process.
  void giveUp(const std::string& part);

  const Experiment& experiment() const;
  const Space& space() const;
  /// Enables the timing of ticks, phase by phase. This makes the ticks of diffusion with ten footbots a tenth longer.
  void timePhases() { are_phases_timed_ = true; }
  /// Times of the last tick; all 0 while timing is off.
  const PhaseTimes& phaseTimes() const { return phase_times_; }
  const std::vector<ControllerFailure>& failures() const;
  /// Robots that have a controller.
  std::size_t robotCount() const;
  /// State of a robot's controller; nothing for an entity without a controller.
  std::optional<ControllerStatus> controllerStatus(Row row) const;
  std::uint64_t stateHash() const { return swarmanoid::stateHash(space()); }
  Metrics metrics() const;
  /// In the order of Space::engines. Allocates.
  std::vector<EngineReport> engineReports() const;
  /// Replaces the drawings by the current ones of all devices; for observers in `draw`, and between ticks. A type of
  /// device has a drawing even if it is empty. @throws exceptions of devices
  void drawDevices(DeviceDrawings& drawings) const;
  /// The current parameters of an engine: those of the file, and later changes.
  /// @throws ConfigError if there is no such engine
  const Configuration& engineParameters(const std::string& engine) const;
  /// The common verdict of the rules and observers that judge the run; nothing if none judges.
  std::optional<bool> success() const;

  /// The outcome of the run so far.
  RunOutcome outcome() const;

  /// For code that transports frames between this simulation and participants.
  Lockstep& lockstep();
  /// Ends a tick that waits for participants with an exception; later ticks do not wait. From any thread.
  void interrupt();
  /// Makes a tick that waits for participants call `is_disturbed` again. From any thread.
  void wake();

  /// Adds an observer to the run. Before start(), or between ticks.
  void addObserver(std::shared_ptr<Observer> observer);

  /// Sets the sink of robots' logs; by default logs are dropped.
  void setLogSink(Robot::LogSink sink);

  /// Between ticks: carries out an intervention at once. From the next tick on it is listed in Space::interventions,
  /// and its effects are events. An intervention that changes nothing is not listed and has no event.
  /// @throws ConfigError with the reason of the refusal; then nothing has changed
  void apply(const Intervention& intervention);
  /// Carries out these interventions too, in this run and again after each reset, each before its tick. A refused one
  /// ends the run: tick() throws a std::runtime_error with file, line, tick and reason. @pre before the first tick
  void play(InterventionPlayer player);
  /// Number of played interventions that are still to come.
  std::size_t interventionsLeft() const { return player_.left(); }
  /// Between ticks: from the next one on, sensors, actuators, controllers of this process, rules and spawned entities
  /// draw their random numbers with another seed. Earlier results stay: positions, memory of errors.
  void reseed(std::uint64_t seed);
  /// Resets to the state before tick 0: undoes spawns, deletions and handovers, and restores the parameters of engines
  /// from the file. `seed` replaces the experiment's if given. Space::time_before_reset grows so that ROS time keeps
  /// rising, unless `rewind` sets it back to 0.
  void reset(std::optional<std::uint64_t> seed = std::nullopt, bool rewind = false);

  /// Between ticks: the whole state of the run. Observers, and state in other processes, are not part of it.
  /// @throws std::runtime_error naming a controller, device, engine or rule that does not define its state
  /// (StateArchive), or a robot that is commanded from another process
  std::shared_ptr<const Snapshot> snapshot() const;
  /// Between ticks: goes on from a snapshot of this simulation, or of another one of the same experiment; parameters
  /// and overrides of this one stay. Robots keep their controllers if the entities are the same; otherwise these start
  /// anew and get their state. Observers begin a new run, as after a reset, and Space::time_before_reset grows so that
  /// ROS time keeps rising.
  /// @throws ConfigError if the snapshot is of another experiment; then nothing has changed
  void restore(const Snapshot& snapshot);

 private:
  void resetRules();
  void beginTick();
  void switchPower();
  void playInterventions(bool after_rules);
  void showPending();
  bool runRules();
  void stopFailedRobots(bool have_failed, bool are_stopping);
  void noteFailures();
  void removeFallen();
  void logNewOverflows();

  std::unique_ptr<World> world_;     // the space, and all objects that act on it
  std::vector<Row> faulty_;          // scratch of `actuate`
  std::vector<Row> fallen_;          // scratch of `fall`
  std::unique_ptr<Snapshot> start_;  // the state that `reset` starts from; null: it builds the world anew
  InterventionPlayer player_;
  bool are_phases_timed_ = false;
  PhaseTimes phase_times_;
  std::size_t logged_overflows_ = 0;
  std::chrono::steady_clock::time_point next_flush_;
  bool is_started_ = false;
  bool rules_have_begun_ = false;  // for the next tick
  bool has_sensed_ = false;        // for the next tick, and nothing has changed since
  bool finish_asked_ = false;
  bool finished_ = false;
};

}  // namespace swarmanoid

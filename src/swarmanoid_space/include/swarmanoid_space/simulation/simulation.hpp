/// A running experiment: the space, and all that acts on it.
///
/// Threads  all functions from one thread (the space's), unless they say otherwise.
/// ROS      is not known here: the space nodelet and the command-line program both hold one of these.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "swarmanoid_space/experiment_file/experiment.hpp"
#include "swarmanoid_space/intervention.hpp"
#include "swarmanoid_space/observer.hpp"
#include "swarmanoid_space/simulation/intervention_player.hpp"
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
  double connect = 0.0;  ///< and handover, and falling into holes
  double index = 0.0;
  double rule = 0.0;  ///< and what rules do before the tick
  double show = 0.0;
  std::vector<double> engines;  ///< of `move`: each engine by itself, in the order of Space::engines

  PhaseTimes& operator+=(const PhaseTimes& other);
};

/// Who commands a robot now, and whether its controller has failed since the robot came.
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

  /// Shows the state before the first tick. Call once, before tick().
  void start();
  /// One tick (thesis 3.1), phases in the order of PhaseTimes. Does nothing once finished.
  /// @param is_disturbed while the tick waits for participants, and at each `wake`: whether an action on
  /// the simulation waits for the end of the tick
  /// @return false: it was disturbed and given up before anything happened; it is to be made again, after that
  bool tick(const std::function<bool()>& is_disturbed = nullptr);
  /// Between ticks: what the next tick begins with is done now (what rules do before it, and `sense`), so that readings
  /// are those that its controllers get. For whoever decides outside of controllers what robots do. Does nothing once
  /// finished. @throws what rules throw
  void sense();
  /// maxclock is reached, or a rule or an observer asked to finish.
  bool isFinished() const;
  /// The same, but not for a run that `finish` has ended before.
  bool hasReachedEnd() const;
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

  const Experiment& experiment() const;
  const Space& space() const;
  /// From now on ticks are timed, phase by phase: those of ten footbots of diffusion take a tenth longer then.
  void timePhases() { are_phases_timed_ = true; }
  /// Of the last tick; all 0 while ticks are not timed.
  const PhaseTimes& phaseTimes() const { return phase_times_; }
  const std::vector<ControllerFailure>& failures() const;
  /// Robots that have a controller.
  std::size_t robotCount() const;
  /// Of a robot; nothing for an entity without a controller.
  std::optional<ControllerStatus> controllerStatus(Row row) const;
  std::uint64_t stateHash() const { return swarmanoid::stateHash(space()); }
  Metrics metrics() const;
  /// In the order of Space::engines. Allocates.
  std::vector<EngineReport> engineReports() const;
  /// Replaces what was drawn by what devices have to show now; for observers in `draw`, and between ticks. A type of
  /// device has a drawing though it is empty. @throws what devices throw
  void drawDevices(DeviceDrawings& drawings) const;
  /// The values that an engine works with: those of the file, and what was set since.
  /// @throws ConfigError if there is no such engine
  const Configuration& engineParameters(const std::string& engine) const;
  /// What the rules and observers that judge it agree on; nothing if none judges.
  std::optional<bool> success() const;

  /// What has come of the run so far.
  RunOutcome outcome() const;

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

  /// Between ticks: does what an intervention asks for, at once. It stands in Space::interventions, and what happens is
  /// an event, from the next tick on. One that changes nothing is neither.
  /// @throws ConfigError why it is refused; then nothing has changed
  void apply(const Intervention& intervention);
  /// In this run, and after each reset again, these interventions are carried out too, each before its tick. One that
  /// is refused ends the run: tick() throws a std::runtime_error with file, line, tick and reason. @pre before the
  /// first tick
  void play(InterventionPlayer player);
  /// How many of those that are played are still to come.
  std::size_t interventionsLeft() const { return player_.left(); }
  /// Between ticks: from the next one on sensors, actuators, controllers of this process, rules and what is spawned
  /// draw their random numbers with another seed. What was drawn stays: places, what an error keeps.
  void reseed(std::uint64_t seed);
  /// Back to the state before tick 0: spawned, deleted and handed over entities included, and parameters of engines as
  /// in the file. `seed` replaces the experiment's if given. Space::time_before_reset grows so that ROS time keeps
  /// rising, unless `rewind` sets it back to 0.
  void reset(std::optional<std::uint64_t> seed = std::nullopt, bool rewind = false);

 private:
  void resetRules();
  void beginTick();
  void switchPower();
  void playInterventions(bool after_rules);
  void showPending();
  bool askRules();
  void stopWhoMust(bool have_failed, bool have_been_told);
  void noteFailures();
  void takeOutFallen();
  void logNewOverflows();

  std::unique_ptr<World> world_;  // the space, and all that acts on it
  std::vector<Row> faulty_;       // scratch of `actuate`
  std::vector<Row> fallen_;       // scratch of `fall`
  InterventionPlayer player_;
  bool are_phases_timed_ = false;
  PhaseTimes phase_times_;
  std::size_t logged_overflows_ = 0;
  std::chrono::steady_clock::time_point next_flush_;
  bool is_started_ = false;
  bool rules_have_begun_ = false;  // the tick that is to come
  bool has_sensed_ = false;        // the tick that is to come, and nothing has changed since
  bool finish_asked_ = false;
  bool finished_ = false;
};

}  // namespace swarmanoid

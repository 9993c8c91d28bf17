/// Runs a simulation on its own thread, at a chosen pace; other threads pause it, step it and act on it between ticks.
///
/// Threads  all functions from any thread except the simulation's own. They wait for the tick boundary: when a function
///          returns, its request is done, and no caller sees a half-updated space. A tick that waits for participants
///          is interrupted for them: see Simulation::tick.
/// Time     paced by the wall clock; nothing here changes what a tick computes.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <future>
#include <memory>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>

#include "swarmanoid_space/simulation/simulation.hpp"

namespace swarmanoid {

/// The simulation's thread has been in users' code for too long to wait for it (user_code_watch.hpp).
class SimulationBusy : public std::runtime_error {
 public:
  /// @param call text of lateUserCall()
  explicit SimulationBusy(const std::string& call) : std::runtime_error("busy in " + call) {}
};

/// A caller that waits for the simulation's thread gets a SimulationBusy if the thread is late in users' code. Its
/// request is then not carried out, unless it has begun.
class SimulationThread {
 public:
  enum class State {
    kPaused,
    kRunning,
    kStepping,  ///< paused, with ticks of a step under way
    kFinished,  ///< only a reset continues from here; observers may still be completing their output
    kStopped    ///< final: stop() was called, or a tick threw; observers may still be completing their output
  };

  struct Options {
    bool paused = false;
    double real_time_factor = 0.0;  ///< simulated seconds for each real one; 0: as fast as possible
    /// Called at a tick boundary, on the simulation's thread, after every change of state and every completed call, so
    /// that rarely sent messages can be published now. The text is the reason if the state is kStopped.
    std::function<void(const Simulation&, State, const std::string&)> on_change;
  };

  struct StepResult {
    bool is_complete = false;
    std::string message;  ///< reason if it is not complete
    std::uint64_t tick = 0;
    Time time;  ///< never goes back, see Space::time_before_reset
  };

  /// Starts the simulation. @pre Simulation::start was not called
  SimulationThread(std::unique_ptr<Simulation> simulation, Options options);
  /// Stops the simulation; observers complete their output.
  ~SimulationThread();
  SimulationThread(const SimulationThread&) = delete;
  SimulationThread& operator=(const SimulationThread&) = delete;

  State state() const;
  /// Reason of the state kStopped; "" in other states.
  std::string stopReason() const;

  /// Also ends a current step. @return false if it was paused already @throws std::runtime_error if stopped
  bool pause();
  /// @return false if it was running already @throws std::runtime_error if finished or stopped
  bool resume();
  /// Makes `ticks` ticks as fast as possible and waits for them. Only while paused, one at a time.
  StepResult step(std::uint64_t ticks);

  double realTimeFactor() const;
  /// Sets simulated seconds per real second from now on, over resets too; 0: as fast as possible.
  /// @throws std::runtime_error if stopped @pre it is not negative
  void setRealTimeFactor(double factor);

  /// Runs an action on the simulation at the next tick boundary. Rethrows exceptions of `action`.
  /// @throws std::runtime_error if stopped
  void call(const std::function<void(Simulation&)>& action);

  /// The same for an action that calls users' code. The action must own all its data, since it may continue after this
  /// function has thrown a SimulationBusy.
  void callUsers(const std::function<void(Simulation&)>& action);

  /// The same for callers that only read; does not call on_change.
  void look(const std::function<void(const Simulation&)>& action) const;

  /// Resets to before the first tick; paused or running as before. See Simulation::reset.
  /// @throws exceptions of Simulation::reset; the run is stopped then
  void reset(std::optional<std::uint64_t> seed, bool rewind);

  /// Ends the run at the next tick boundary; observers complete their output. Later reasons are ignored.
  void stop(const std::string& reason);

 private:
  struct JobKind {
    bool is_change = true;
    bool owns_all = false;  ///< the caller need not wait for its end
  };
  struct Job {
    std::function<void()> action;
    JobKind kind;
    std::uint64_t number;
    std::promise<void> done;
  };
  struct Step {
    explicit Step(std::uint64_t ticks) : left(ticks) {}
    std::uint64_t left;
    std::promise<StepResult> done;
  };

  void run();
  void start(std::unique_lock<std::mutex>& lock);
  void doJob(const Job& job, std::unique_lock<std::mutex>& lock);
  void runJobs(std::unique_lock<std::mutex>& lock);
  void makeTick(std::unique_lock<std::mutex>& lock);
  bool waitUntilDue(std::unique_lock<std::mutex>& lock);
  void endStep(const std::string& problem);
  void complete(std::unique_lock<std::mutex>& lock);
  void announce();
  void enqueueAndWait(std::function<void()> action, JobKind kind) const;
  bool letGo(std::uint64_t job, JobKind kind) const;

  std::unique_ptr<Simulation> simulation_;
  Options options_;

  mutable std::mutex mutex_;  // guards all following members
  mutable std::condition_variable wake_;
  mutable std::deque<Job> jobs_;
  mutable std::uint64_t last_job_ = 0;
  State state_ = State::kPaused;
  bool is_over_ = false;                       // the thread takes no more jobs
  mutable std::atomic<bool> has_jobs_{false};  // written under the mutex, read by a waiting tick
  std::optional<std::string> stop_reason_;

  // used only on the thread
  std::optional<Step> step_;
  bool is_tick_given_up_ = false;  // the next tick is due at once
  std::optional<std::chrono::steady_clock::time_point> next_tick_;

  std::thread thread_;
};

/// Returns "paused", "running", "stepping", "finished" or "stopped".
const char* toString(SimulationThread::State state);

}  // namespace swarmanoid

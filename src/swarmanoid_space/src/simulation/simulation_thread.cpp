#include "swarmanoid_space/simulation/simulation_thread.hpp"

#include <algorithm>
#include <chrono>

#include "swarmanoid_interface/expects.hpp"
#include "swarmanoid_interface/process/user_code_watch.hpp"

namespace swarmanoid {

using Clock = std::chrono::steady_clock;

namespace {

/// @param let_go cancels the awaited job, and returns whether the caller may stop waiting @return the job's result
/// @throws SimulationBusy if users' code is late and the caller may stop waiting
template <class Result, class LetGo>
Result waitUnlessLate(std::future<Result>& result, LetGo let_go) {
  constexpr auto kInterval = std::chrono::milliseconds(200);
  while (result.wait_for(kInterval) == std::future_status::timeout) {
    const std::string late = lateUserCall();
    if (!late.empty() && let_go()) {
      throw SimulationBusy(late);
    }
  }
  return result.get();
}

/// Unlocks the mutex while users' code and observers run, which may take long, so that callers are answered meanwhile.
class Unlocked {
 public:
  explicit Unlocked(std::unique_lock<std::mutex>& lock) : lock_(lock) { lock_.unlock(); }
  ~Unlocked() { lock_.lock(); }
  Unlocked(const Unlocked&) = delete;
  Unlocked& operator=(const Unlocked&) = delete;

 private:
  std::unique_lock<std::mutex>& lock_;
};

}  // namespace

SimulationThread::SimulationThread(std::unique_ptr<Simulation> simulation, Options options)
    : simulation_(std::move(simulation)), options_(std::move(options)) {
  state_ = options_.paused ? State::kPaused : State::kRunning;
  thread_ = std::thread([this] { run(); });
}

SimulationThread::~SimulationThread() {
  stop("shut down");
  thread_.join();
}

SimulationThread::State SimulationThread::state() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return state_;
}

std::string SimulationThread::stopReason() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return state_ == State::kStopped ? stop_reason_.value_or("") : "";
}

void SimulationThread::enqueueAndWait(std::function<void()> action, JobKind kind) const {
  std::future<void> done;
  std::uint64_t number = 0;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (is_over_) {
      throw std::runtime_error("the run has stopped: " + stop_reason_.value_or(""));
    }
    number = ++last_job_;
    jobs_.push_back({std::move(action), kind, number, {}});
    has_jobs_ = true;
    done = jobs_.back().done.get_future();
  }
  wake_.notify_all();
  simulation_->wake();
  waitUnlessLate(done, [&] { return letGo(number, kind); });
}

/// @return false if the job has begun and uses data of the waiting caller
bool SimulationThread::letGo(std::uint64_t job, JobKind kind) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto found =
      std::find_if(jobs_.begin(), jobs_.end(), [job](const Job& candidate) { return candidate.number == job; });
  if (found != jobs_.end()) {
    jobs_.erase(found);
    has_jobs_ = !jobs_.empty();
    return true;
  }
  return kind.owns_all;
}

void SimulationThread::call(const std::function<void(Simulation&)>& action) {
  enqueueAndWait([&] { action(*simulation_); }, {});
}

void SimulationThread::callUsers(const std::function<void(Simulation&)>& action) {
  JobKind kind;
  kind.owns_all = true;
  enqueueAndWait([this, action] { action(*simulation_); }, kind);
}

void SimulationThread::look(const std::function<void(const Simulation&)>& action) const {
  JobKind kind;
  kind.is_change = false;
  enqueueAndWait([&] { action(*simulation_); }, kind);
}

void SimulationThread::reset(std::optional<std::uint64_t> seed, bool rewind) {
  JobKind kind;
  kind.owns_all = true;
  const auto act = [this, seed, rewind] {
    std::unique_lock<std::mutex> lock(mutex_);
    endStep("reset before all of them were made");
    try {
      const Unlocked unlocked(lock);
      simulation_->reset(seed, rewind);
    } catch (...) {
      if (!stop_reason_) {
        stop_reason_ = "the reset failed: " + describeException();  // the space is half built
      }
      throw;
    }
    state_ = options_.paused ? State::kPaused : State::kRunning;
    next_tick_.reset();
  };
  enqueueAndWait(act, kind);
}

bool SimulationThread::pause() {
  bool is_change = false;
  const auto act = [&] {
    const std::lock_guard<std::mutex> lock(mutex_);
    is_change = state_ == State::kRunning || state_ == State::kStepping;
    options_.paused = true;
    if (is_change) {
      state_ = State::kPaused;
      endStep("paused before all of them were made");
    }
  };
  enqueueAndWait(act, {});
  return is_change;
}

bool SimulationThread::resume() {
  bool is_change = false;
  const auto act = [&] {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (state_ == State::kFinished) {
      throw std::runtime_error("the run is finished; only a reset goes on from here");
    }
    is_change = state_ == State::kPaused || state_ == State::kStepping;
    options_.paused = false;
    if (is_change) {
      endStep("resumed before all of them were made");
      state_ = State::kRunning;
      next_tick_.reset();
    }
  };
  enqueueAndWait(act, {});
  return is_change;
}

double SimulationThread::realTimeFactor() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return options_.real_time_factor;
}

void SimulationThread::setRealTimeFactor(double factor) {
  SWARMANOID_EXPECTS(factor >= 0.0);
  JobKind kind;
  kind.is_change = false;  // the simulated state does not change
  const auto act = [&] {
    const std::lock_guard<std::mutex> lock(mutex_);
    options_.real_time_factor = factor;
    next_tick_.reset();  // otherwise a lag or lead at the old pace would be made up at the new one
  };
  enqueueAndWait(act, kind);
}

SimulationThread::StepResult SimulationThread::step(std::uint64_t ticks) {
  std::future<StepResult> result;
  const auto act = [&] {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (step_) {
      throw std::runtime_error("another step is under way");
    }
    step_.emplace(ticks);
    result = step_->done.get_future();
    if (state_ == State::kFinished) {
      endStep("the run is finished; only a reset goes on from here");
    } else if (state_ == State::kRunning) {
      endStep("it is running; pause it first");
    } else if (ticks == 0) {
      endStep("");
    } else {
      state_ = State::kStepping;
    }
  };
  enqueueAndWait(act, {});
  return waitUnlessLate(result, [] { return true; });
}

void SimulationThread::stop(const std::string& reason) {
  std::unique_lock<std::mutex> lock(mutex_);
  if (!stop_reason_) {
    stop_reason_ = reason;
  }
  simulation_->interrupt();
  wake_.notify_all();
  wake_.wait(lock, [this] { return is_over_; });
}

void SimulationThread::run() {
  std::unique_lock<std::mutex> lock(mutex_);
  try {
    start(lock);
    while (!stop_reason_) {
      runJobs(lock);
      if (!stop_reason_ && waitUntilDue(lock)) {
        makeTick(lock);
      }
    }
  } catch (...) {
    if (!stop_reason_) {  // otherwise the run was stopped meanwhile, which may have caused the exception
      stop_reason_ = "tick " + std::to_string(simulation_->space().tick) + ": " + describeException();
    }
  }
  state_ = State::kStopped;
  endStep("the run has stopped: " + *stop_reason_);
  try {
    complete(lock);
  } catch (...) {
    *stop_reason_ += "; " + describeException();
  }
  is_over_ = true;
  for (Job& job : jobs_) {
    job.done.set_exception(
        std::make_exception_ptr(std::runtime_error("the run has stopped: " + stop_reason_.value_or(""))));
  }
  jobs_.clear();
  wake_.notify_all();
}

void SimulationThread::start(std::unique_lock<std::mutex>& lock) {
  {
    const Unlocked unlocked(lock);
    simulation_->start();
  }
  announce();
}

void SimulationThread::doJob(const Job& job, std::unique_lock<std::mutex>& lock) {
  {
    const Unlocked unlocked(lock);
    job.action();
  }
  if (job.kind.is_change) {
    announce();
  }
}

void SimulationThread::runJobs(std::unique_lock<std::mutex>& lock) {
  while (!jobs_.empty() && !stop_reason_) {
    Job job = std::move(jobs_.front());
    jobs_.pop_front();
    try {
      doJob(job, lock);
      job.done.set_value();
    } catch (...) {
      job.done.set_exception(std::current_exception());
    }
  }
  has_jobs_ = !jobs_.empty();
}

bool SimulationThread::waitUntilDue(std::unique_lock<std::mutex>& lock) {
  const auto isDisturbed = [this] { return stop_reason_.has_value() || !jobs_.empty(); };
  if (state_ == State::kStepping) {
    return true;
  }
  if (state_ != State::kRunning) {
    {
      const Unlocked unlocked(lock);
      simulation_->flush();
    }
    wake_.wait(lock, isDisturbed);
    return false;
  }
  if (options_.real_time_factor <= 0.0 || is_tick_given_up_) {
    return true;
  }
  const auto now = Clock::now();
  if (!next_tick_) {
    next_tick_ = now;
  }
  if (wake_.wait_until(lock, *next_tick_, isDisturbed)) {
    return false;
  }
  // a larger delay is accepted instead of made up by faster ticks
  constexpr auto kLargestDelay = std::chrono::milliseconds(250);
  if (Clock::now() - *next_tick_ > kLargestDelay) {
    next_tick_ = Clock::now();
  }
  *next_tick_ +=
      std::chrono::duration_cast<Clock::duration>(simulation_->space().clocktick / options_.real_time_factor);
  return true;
}

void SimulationThread::makeTick(std::unique_lock<std::mutex>& lock) {
  {
    const Unlocked unlocked(lock);
    is_tick_given_up_ = !simulation_->tick([this] { return has_jobs_.load(); });
  }
  if (is_tick_given_up_) {
    return;
  }
  const bool is_step_done = step_ && --step_->left == 0;
  if (simulation_->isFinished()) {
    state_ = State::kFinished;
    complete(lock);
    endStep(is_step_done ? "" : "the run finished before all of them were made");
  } else if (is_step_done) {
    state_ = State::kPaused;
    announce();
    endStep("");
  }
}

void SimulationThread::endStep(const std::string& problem) {
  if (step_) {
    const Space& space = simulation_->space();
    step_->done.set_value({problem.empty(), problem, space.tick, space.time + space.time_before_reset});
    step_.reset();
  }
}

void SimulationThread::complete(std::unique_lock<std::mutex>& lock) {
  announce();
  const Unlocked unlocked(lock);
  simulation_->finish();
}

void SimulationThread::announce() {
  if (options_.on_change) {
    options_.on_change(*simulation_, state_, state_ == State::kStopped ? stop_reason_.value_or("") : "");
  }
}

const char* toString(SimulationThread::State state) {
  switch (state) {
    case SimulationThread::State::kPaused:
      return "paused";
    case SimulationThread::State::kRunning:
      return "running";
    case SimulationThread::State::kStepping:
      return "stepping";
    case SimulationThread::State::kFinished:
      return "finished";
    case SimulationThread::State::kStopped:
      return "stopped";
  }
  return "";
}

}  // namespace swarmanoid

#include "swarmanoid_space/simulation_thread.hpp"

#include <chrono>
#include <stdexcept>

namespace swarmanoid {

using Clock = std::chrono::steady_clock;

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

void SimulationThread::enqueueAndWait(std::function<void()> action, bool is_change) const {
  std::future<void> done;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (is_over_) {
      throw std::runtime_error("the run has stopped: " + stop_reason_.value_or(""));
    }
    jobs_.push_back({std::move(action), is_change, {}});
    has_jobs_ = true;
    done = jobs_.back().done.get_future();
  }
  wake_.notify_all();
  simulation_->wake();
  done.get();
}

void SimulationThread::call(const std::function<void(Simulation&)>& action) {
  enqueueAndWait([&] { action(*simulation_); });
}

void SimulationThread::look(const std::function<void(const Simulation&)>& action) const {
  constexpr bool kChange = true;
  enqueueAndWait([&] { action(*simulation_); }, !kChange);
}

void SimulationThread::reset(std::optional<std::uint64_t> seed, bool rewind) {
  enqueueAndWait([&] {
    endStep("reset before all of them were made");
    try {
      simulation_->reset(seed, rewind);
    } catch (const std::exception& error) {
      stop_reason_ = std::string("the reset failed: ") + error.what();  // the space is half built
      throw;
    }
    state_ = options_.paused ? State::kPaused : State::kRunning;
    next_tick_.reset();
  });
}

bool SimulationThread::pause() {
  bool is_change = false;
  enqueueAndWait([&] {
    is_change = state_ == State::kRunning || state_ == State::kStepping;
    options_.paused = true;
    if (is_change) {
      state_ = State::kPaused;
      endStep("paused before all of them were made");
    }
  });
  return is_change;
}

bool SimulationThread::resume() {
  bool is_change = false;
  enqueueAndWait([&] {
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
  });
  return is_change;
}

SimulationThread::StepResult SimulationThread::step(std::uint64_t ticks) {
  std::future<StepResult> result;
  enqueueAndWait([&] {
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
  });
  return result.get();
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
  const auto stopOn = [&](const std::exception& error) {
    // a job or a tick threw on this thread; the lock may be held or not
    if (!lock.owns_lock()) {
      lock.lock();
    }
    if (stop_reason_) {
      return;  // stopped meanwhile, which may be why it threw
    }
    stop_reason_ = "tick " + std::to_string(simulation_->space().tick) + ": " + error.what();
  };
  try {
    simulation_->start();
    announce();
    while (!stop_reason_) {
      runJobs(lock);
      if (!stop_reason_ && waitUntilDue(lock)) {
        makeTick(lock);
      }
    }
  } catch (const std::exception& error) {
    stopOn(error);
  }
  state_ = State::kStopped;
  endStep("the run has stopped: " + *stop_reason_);
  try {
    complete();
  } catch (const std::exception& error) {
    *stop_reason_ += std::string("; ") + error.what();
  }
  is_over_ = true;
  for (Job& job : jobs_) {
    job.done.set_exception(
        std::make_exception_ptr(std::runtime_error("the run has stopped: " + stop_reason_.value_or(""))));
  }
  jobs_.clear();
  wake_.notify_all();
}

void SimulationThread::runJobs(std::unique_lock<std::mutex>& lock) {
  while (!jobs_.empty() && !stop_reason_) {
    Job job = std::move(jobs_.front());
    jobs_.pop_front();
    // held by nobody else: state_ is only written on this thread, and read by others under the lock
    try {
      job.action();
      if (job.is_change) {
        announce();
      }
      lock.unlock();
      job.done.set_value();
    } catch (...) {
      if (lock.owns_lock()) {
        lock.unlock();
      }
      job.done.set_exception(std::current_exception());
    }
    lock.lock();
  }
  has_jobs_ = !jobs_.empty();
}

bool SimulationThread::waitUntilDue(std::unique_lock<std::mutex>& lock) {
  const auto isDisturbed = [this] { return stop_reason_.has_value() || !jobs_.empty(); };
  if (state_ == State::kStepping) {
    return true;
  }
  if (state_ != State::kRunning) {
    lock.unlock();
    simulation_->flush();
    lock.lock();
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
  // behind by more than this, the delay is accepted instead of made good in a rush
  constexpr auto kLargestDelay = std::chrono::milliseconds(250);
  if (Clock::now() - *next_tick_ > kLargestDelay) {
    next_tick_ = Clock::now();
  }
  *next_tick_ +=
      std::chrono::duration_cast<Clock::duration>(simulation_->space().clocktick / options_.real_time_factor);
  return true;
}

void SimulationThread::makeTick(std::unique_lock<std::mutex>& lock) {
  lock.unlock();
  is_tick_given_up_ = !simulation_->tick([this] { return has_jobs_.load(); });
  lock.lock();
  if (is_tick_given_up_) {
    return;
  }
  const bool is_step_done = step_ && --step_->left == 0;
  if (simulation_->isFinished()) {
    state_ = State::kFinished;
    complete();
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

void SimulationThread::complete() {
  announce();
  simulation_->finish();
}

void SimulationThread::announce() {
  if (options_.on_change) {
    options_.on_change(*simulation_, state_, state_ == State::kStopped ? stop_reason_.value_or("") : "");
  }
}

}  // namespace swarmanoid

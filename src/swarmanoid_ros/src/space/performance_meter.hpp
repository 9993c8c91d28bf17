/// Measures how fast a simulation runs.
#pragma once

#include <swarmanoid_msgs/Performance.h>

#include <chrono>

#include "swarmanoid_space/simulation/simulation.hpp"

namespace swarmanoid {

class PerformanceMeter {
 public:
  using Clock = std::chrono::steady_clock;

  /// Adds a tick. It is called after each tick.
  void add(const PhaseTimes& phases, std::size_t robots) {
    sum_ += phases;
    robot_ticks_ += static_cast<double>(robots);
    ticks_ += 1.0;
  }

  double seconds(Clock::time_point now) const { return std::chrono::duration<double>(now - start_).count(); }

  /// Restarts the measurement, such as after a pause.
  void restart(Clock::time_point now) { *this = PerformanceMeter(now); }

  /// Returns the means since the last restart; the caller sets the header.
  swarmanoid_msgs::Performance means(const Space& space, Clock::time_point now) const {
    swarmanoid_msgs::Performance message;
    message.tick = space.tick;
    message.run = space.run;
    const double wall_s = seconds(now);
    if (ticks_ > 0.0 && wall_s > 0.0) {
      message.real_time_factor = ticks_ * toSeconds(space.clocktick) / wall_s;
      message.ticks_per_s = ticks_ / wall_s;
      message.robot_ticks_per_s = robot_ticks_ / wall_s;
      message.sense = sum_.sense / ticks_;
      message.control = sum_.control / ticks_;
      message.actuate = sum_.actuate / ticks_;
      message.move = sum_.move / ticks_;
      message.connect = sum_.connect / ticks_;
      message.index = sum_.index / ticks_;
      message.power = sum_.power / ticks_;
      message.rule = sum_.rule / ticks_;
      message.show = sum_.show / ticks_;
      for (std::size_t i = 0; i < sum_.engines.size(); ++i) {
        swarmanoid_msgs::EngineTime engine;
        engine.engine = space.engines[i]->id();
        engine.move = sum_.engines[i] / ticks_;
        message.engines.push_back(engine);
      }
    }
    return message;
  }

  explicit PerformanceMeter(Clock::time_point start = Clock::now()) : start_(start) {}

 private:
  Clock::time_point start_;
  PhaseTimes sum_;
  double robot_ticks_ = 0.0;
  double ticks_ = 0.0;
};

}  // namespace swarmanoid

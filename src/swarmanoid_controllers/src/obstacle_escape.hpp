/// How footbots turn away from obstacles ahead and leave them.
#pragma once

#include <algorithm>

#include "differential_drive.hpp"

namespace swarmanoid {

class ObstacleEscape {
 public:
  void reset() { *this = ObstacleEscape{}; }

  /// Turns away from obstacles ahead, then drives straight on for a while: an immediate turn back would lead to the
  /// same obstacle.
  /// @param speed of driving straight on [m/s] @param dt since the last call [s] @return whether the wheels were
  /// commanded
  bool drive(FootbotWheels& wheels, const FootbotProximity& proximity, RandomStream& random, double speed, double dt) {
    constexpr double kThreshold = 0.05;
    constexpr double kHalfField = 1.5;  // rad: obstacles beside and behind the robot do not count
    constexpr double kTurnRate = 1.5;   // rad/s
    const ObstacleVector obstacle(proximity, kHalfField);
    if (obstacle.length() > kThreshold) {
      if (turn_ == 0.0) {  // a turn keeps its side; in a corner it would oscillate otherwise
        turn_ = obstacle.y > 0.0 ? -kTurnRate : kTurnRate;
        time_left_ = random.uniform(0.5, 2.0);
      }
      wheels.drive(0.0, turn_);
      return true;
    }
    turn_ = 0.0;
    time_left_ = std::max(0.0, time_left_ - dt);
    if (time_left_ > 0.0) {
      wheels.drive(speed, 0.0);
      return true;
    }
    return false;
  }

 private:
  double turn_ = 0.0;       // rad/s, while the robot turns away from an obstacle
  double time_left_ = 0.0;  // s of driving straight on after that
};

}  // namespace swarmanoid

// Diffusion: the robot drives straight on to the next obstacle ahead, then turns until the way is free. For footbots,
// and for any robot with a differential drive and proximity sensors.
#include "differential_drive.hpp"
#include "swarmanoid_interface/controller.hpp"

namespace swarmanoid {

class Diffusion final : public Controller {
 public:
  void init(Robot& robot, const Configuration& parameters) override {
    base_ = MobileBase(robot);
    speed_ = parameters.number("speed", 0.1, {0.0, 0.3});
    threshold_ = parameters.number("threshold", 0.05, {0.0, 10.0});
    parameters.refuseUnread({"speed", "threshold"});
  }

  void reset() override { turn_rate_ = 0.0; }

  void step(Time, Duration) override {
    // obstacles beside and behind do not count: they would outweigh those ahead
    constexpr double kHalfField = 1.5;  // rad
    const ObstacleVector obstacle = base_.obstacles(kHalfField);
    if (obstacle.length() <= threshold_) {
      turn_rate_ = 0.0;
      base_.drive(speed_, 0.0);
      return;
    }
    if (turn_rate_ == 0.0) {             // a turn keeps its side; in a corner it would oscillate otherwise
      constexpr double kTurnRate = 1.5;  // rad/s
      turn_rate_ = obstacle.y > 0.0 ? -kTurnRate : kTurnRate;
    }
    base_.drive(0.0, turn_rate_);
  }

  void archive(StateArchive& state) override { state(turn_rate_); }

 private:
  MobileBase base_;
  double speed_ = 0.0;      // m/s
  double threshold_ = 0.0;  // length of the obstacle vector
  double turn_rate_ = 0.0;  // rad/s, while it turns away
};

}  // namespace swarmanoid

REGISTER_CONTROLLER(swarmanoid::Diffusion, "diffusion")

// Diffusion: straight on until something is near, then turn away from it.
#include "differential_drive.hpp"
#include "swarmanoid_interface/controller.hpp"

namespace swarmanoid {

class Diffusion final : public Controller {
 public:
  void init(Robot& robot, const Configuration& parameters) override {
    wheels_ = &robot.actuator<FootbotWheels>();
    proximity_ = &robot.sensor<FootbotProximity>();
    speed_ = parameters.number("speed", 0.1, {0.0, 0.3});
    threshold_ = parameters.number("threshold", 0.05, {0.0, 10.0});
    parameters.refuseUnread({"speed", "threshold"});
  }

  void step(Time, Duration) override {
    const ObstacleVector obstacle(*proximity_);
    if (obstacle.length() <= threshold_ || obstacle.x < 0.0) {
      wheels_->drive(speed_, 0.0);
    } else {
      constexpr double kTurnRate = 1.5;  // rad/s
      wheels_->drive(0.0, obstacle.y > 0.0 ? -kTurnRate : kTurnRate);
    }
  }

 private:
  FootbotWheels* wheels_ = nullptr;
  const FootbotProximity* proximity_ = nullptr;
  double speed_ = 0.0;      // m/s
  double threshold_ = 0.0;  // length of the obstacle vector
};

}  // namespace swarmanoid

REGISTER_CONTROLLER(swarmanoid::Diffusion, "diffusion")

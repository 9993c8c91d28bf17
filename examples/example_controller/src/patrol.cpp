// Patrol: alternates a leg straight ahead and a turn on the spot; waits while an obstacle is near.
#include <algorithm>

#include "swarmanoid_interface/controller.hpp"
#include "swarmanoid_interface/devices/footbot_proximity.hpp"
#include "swarmanoid_interface/devices/footbot_wheels.hpp"

class Patrol final : public swarmanoid::Controller {
 public:
  void init(swarmanoid::Robot& robot, const swarmanoid::Configuration& parameters) override {
    robot_ = &robot;
    wheels_ = &robot.actuator<swarmanoid::FootbotWheels>();
    proximity_ = &robot.sensor<swarmanoid::FootbotProximity>();
    speed_ = parameters.number("speed", 5.0, {0.0, 10.0});
    leg_ = parameters.number("leg", 2.0, {0.0, 1000.0});
    turn_ = parameters.number("turn", 1.0, {0.0, 1000.0});
    parameters.refuseUnread({"speed", "leg", "turn"});
  }

  void step(swarmanoid::Time, swarmanoid::Duration dt) override {
    const auto& readings = proximity_->value;
    if (*std::max_element(readings.begin(), readings.end()) > 0.0F) {
      wheels_->setAngularVelocity(0.0, 0.0);
      robot_->debug("patrol", "waits");
      return;
    }
    const bool is_turning = swarmanoid::toSeconds(clock_) >= leg_;
    wheels_->setAngularVelocity(is_turning ? -speed_ : speed_, speed_);
    robot_->debug("patrol", is_turning ? "turns" : "walks");
    clock_ += dt;
    if (swarmanoid::toSeconds(clock_) >= leg_ + turn_) {
      clock_ = {};
    }
  }

  void reset() override { clock_ = {}; }

  void archive(swarmanoid::StateArchive& state) override { state(clock_); }

 private:
  swarmanoid::Robot* robot_ = nullptr;
  swarmanoid::FootbotWheels* wheels_ = nullptr;
  const swarmanoid::FootbotProximity* proximity_ = nullptr;
  double speed_ = 0.0;            // of the wheels [rad/s]
  double leg_ = 0.0;              // duration of a leg [s]
  double turn_ = 0.0;             // duration of a turn [s]
  swarmanoid::Duration clock_{};  // time since the start of the leg, without waiting
};

REGISTER_CONTROLLER(Patrol, "patrol")

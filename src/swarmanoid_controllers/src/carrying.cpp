// Two or more footbots carry an object between them: each grips it at its side by the turret, drives, backs off a
// little from the obstacle that it has reached, and releases the object.
#include <cmath>

#include "differential_drive.hpp"
#include "swarmanoid_interface/angle.hpp"
#include "swarmanoid_interface/controller.hpp"
#include "swarmanoid_interface/devices/footbot_gripper.hpp"
#include "swarmanoid_interface/devices/footbot_turret.hpp"
#include "swarmanoid_interface/devices/leds.hpp"

namespace swarmanoid {

class Carrying final : public Controller {
 public:
  void init(Robot& robot, const Configuration& parameters) override {
    robot_ = &robot;
    wheels_ = &robot.actuator<FootbotWheels>();
    gripper_ = &robot.actuator<FootbotGripper>();
    turret_ = &robot.actuator<FootbotTurret>();
    leds_ = &robot.actuator<FootbotLeds>();
    turret_state_ = &robot.sensor<FootbotTurretState>();
    side_ = parameters.angle("side", 0.0);
    speed_ = parameters.number("speed", 0.1, {0.0, 0.3});
    start_ = parameters.number("start", 3.0, {0.0, 1e6});
    stop_ = parameters.number("stop", 10.0, {0.0, 1e6});
    parameters.refuseUnread({"side", "speed", "start", "stop"});
  }

  void step(Time time, Duration) override {
    constexpr double kBacking = 0.4;  // s
    constexpr double kResting = 0.5;  // s, before the object is released
    const double now = toSeconds(time - kEpoch);
    turret_->holdAngle(side_);
    const bool is_turned = std::abs(wrapAngle(turret_state_->angle - side_)) < kClose;
    if (now < start_) {
      gripper_->closed = is_turned;
      show("gripping", colors::kYellow, 0.0);
    } else if (now < stop_) {
      show("carrying", colors::kGreen, speed_);
    } else if (now < stop_ + kBacking) {
      show("backing", colors::kBlue, -0.5 * speed_);
    } else {
      gripper_->closed = now < stop_ + kBacking + kResting;
      show("resting", colors::kBlue, 0.0);
    }
  }

 private:
  static constexpr double kClose = 0.01;  // rad

  void show(const char* state, Color color, double speed) {
    robot_->debug("state", state);
    leds_->setAll(color);
    wheels_->drive(speed, 0.0);
  }

  Robot* robot_ = nullptr;
  FootbotWheels* wheels_ = nullptr;
  FootbotGripper* gripper_ = nullptr;
  FootbotTurret* turret_ = nullptr;
  FootbotLeds* leds_ = nullptr;
  const FootbotTurretState* turret_state_ = nullptr;
  double side_ = 0.0;   // rad, direction of the carried object, counter-clockwise from ahead
  double speed_ = 0.0;  // m/s
  double start_ = 0.0;  // s after the run began, by when all have gripped
  double stop_ = 0.0;   // s
};

}  // namespace swarmanoid

REGISTER_CONTROLLER(swarmanoid::Carrying, "carrying")

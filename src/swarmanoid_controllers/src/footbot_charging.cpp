// A footbot that charges its battery beside perches: it wanders, visits a perch at a low charge, with blue light, until
// the battery is full, and wanders again.
#include "perch_visit.hpp"
#include "swarmanoid_interface/controller.hpp"

namespace swarmanoid {

class FootbotCharging final : public Controller {
 public:
  void init(Robot& robot, const Configuration& parameters) override {
    robot_ = &robot;
    wheels_ = &robot.actuator<FootbotWheels>();
    leds_ = &robot.actuator<FootbotLeds>();
    proximity_ = &robot.sensor<FootbotProximity>();
    speed_ = parameters.number("speed", 0.15, {0.01, 0.3});
    visit_.init(robot, parameters, speed_, {colors::kGreen, colors::kYellow, colors::kBlue});
    refuseEqualColors(parameters, visit_.colors());
    parameters.refuseUnread({"speed", "little", "plenty", "free_color", "taken_color", "charging_color"});
    reset();
  }

  void reset() override {
    *wheels_ = FootbotWheels{};
    leds_->setAll(colors::kBlack);
    visit_.reset();
    startToWander();
  }

  void step(Time, Duration duration) override {
    const double dt = toSeconds(duration);
    visit_.update(dt);
    if (visit_.isUnderWay()) {
      visit_.step();
      if (!visit_.isUnderWay()) {
        startToWander();
      }
    } else if (visit_.isDue()) {
      visit_.begin();
    } else {
      wander(dt);
    }
  }

  void archive(StateArchive& state) override { state(memory_, visit_); }

 private:
  void startToWander() {
    memory_ = Memory{};
    robot_->debug("state", "Wander");
  }

  void wander(double dt) {
    if (memory_.escape.drive(*wheels_, *proximity_, robot_->random(), speed_, dt)) {
      return;
    }
    memory_.turn_rate = wanderingTurnRate(robot_->random(), memory_.turn_rate, dt);
    wheels_->drive(speed_, memory_.turn_rate);
  }

  Robot* robot_ = nullptr;
  FootbotWheels* wheels_ = nullptr;
  FootbotLeds* leds_ = nullptr;
  const FootbotProximity* proximity_ = nullptr;
  double speed_ = 0.0;  // m/s
  PerchVisit visit_;

  /// State that is kept while it wanders.
  struct Memory {
    ObstacleEscape escape;
    double turn_rate = 0.0;  // rad/s
  };
  Memory memory_;
};

}  // namespace swarmanoid

REGISTER_CONTROLLER(swarmanoid::FootbotCharging, "footbot_charging")

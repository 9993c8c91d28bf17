// Group transport: the robots drive up to the object ahead, grip it, wait for the others, then pull together.
#include "differential_drive.hpp"
#include "swarmanoid_interface/controller.hpp"
#include "swarmanoid_interface/devices/footbot_gripper.hpp"
#include "swarmanoid_interface/devices/leds.hpp"

namespace swarmanoid {

class Pulling final : public Controller {
 public:
  void init(Robot& robot, const Configuration& parameters) override {
    robot_ = &robot;
    wheels_ = &robot.actuator<FootbotWheels>();
    gripper_ = &robot.actuator<FootbotGripper>();
    leds_ = &robot.actuator<FootbotLeds>();
    gripper_state_ = &robot.sensor<FootbotGripperState>();
    speed_ = parameters.number("speed", 0.1, {0.0, 0.3});
    start_ = parameters.number("start", 5.0, {0.0, 1e6});
    parameters.refuseUnread({"speed", "start"});
  }

  void step(Time time, Duration) override {
    gripper_->close();
    if (!gripper_state_->gripping) {
      show("approaching", colors::kYellow);
      wheels_->drive(speed_, 0.0);
    } else if (toSeconds(time - kEpoch) < start_) {
      show("waiting", colors::kBlue);
      wheels_->drive(0.0, 0.0);
    } else {
      show("pulling", colors::kGreen);
      wheels_->drive(-speed_, 0.0);
    }
  }

  void archive(StateArchive& /*state*/) override {}

 private:
  void show(const char* state, Color color) {
    robot_->debug("state", state);
    leds_->setAll(color);
  }

  Robot* robot_ = nullptr;
  FootbotWheels* wheels_ = nullptr;
  FootbotGripper* gripper_ = nullptr;
  FootbotLeds* leds_ = nullptr;
  const FootbotGripperState* gripper_state_ = nullptr;
  double speed_ = 0.0;  // m/s
  double start_ = 0.0;  // s after the start of the run, by when all have gripped
};

}  // namespace swarmanoid

REGISTER_CONTROLLER(swarmanoid::Pulling, "pulling")

// A chain: each footbot grips the footbot ahead, and they drive on together.
#include "differential_drive.hpp"
#include "swarmanoid_interface/controller.hpp"
#include "swarmanoid_interface/devices/footbot_gripper.hpp"
#include "swarmanoid_interface/devices/leds.hpp"

namespace swarmanoid {

class Chain final : public Controller {
 public:
  void init(Robot& robot, const Configuration& parameters) override {
    wheels_ = &robot.actuator<FootbotWheels>();
    gripper_ = &robot.actuator<FootbotGripper>();
    leds_ = &robot.actuator<FootbotLeds>();
    gripper_state_ = &robot.sensor<FootbotGripperState>();
    speed_ = parameters.number("speed", 0.1, {0.0, 0.3});
    start_ = parameters.number("start", 1.0, {0.0, 1e6});
    parameters.refuseUnread({"speed", "start"});
  }

  void step(Time time, Duration) override {
    const bool is_time = toSeconds(time - kEpoch) >= start_;
    gripper_->close();
    leds_->setAll(gripper_state_->gripping ? colors::kGreen : colors::kYellow);
    wheels_->drive(is_time ? speed_ : 0.0, 0.0);
  }

  void archive(StateArchive& /*state*/) override {}

 private:
  FootbotWheels* wheels_ = nullptr;
  FootbotGripper* gripper_ = nullptr;
  FootbotLeds* leds_ = nullptr;
  const FootbotGripperState* gripper_state_ = nullptr;
  double speed_ = 0.0;  // m/s
  double start_ = 0.0;  // s after the start of the run, by when all have gripped
};

}  // namespace swarmanoid

REGISTER_CONTROLLER(swarmanoid::Chain, "chain")

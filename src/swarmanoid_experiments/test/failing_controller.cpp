// A controller for tests of the program: drives straight on; parameters make it throw in one tick and log in all of
// them.
#include <stdexcept>
#include <string>

#include "swarmanoid_interface/controller.hpp"
#include "swarmanoid_interface/devices/footbot_wheels.hpp"

namespace swarmanoid::test {

class FailingController final : public Controller {
 public:
  void init(Robot& robot, const Configuration& parameters) override {
    robot_ = &robot;
    wheels_ = &robot.actuator<FootbotWheels>();
    fail_at_ = parameters.integer("fail_at", std::int64_t{-1});
    talks_ = parameters.boolean("talks", false);
    parameters.refuseUnread({"fail_at", "talks"});
  }

  void step(Time, Duration) override {
    wheels_->setAngularVelocity(1.0, 1.0);
    if (talks_) {
      robot_->log("tick " + std::to_string(tick_));
    }
    if (tick_++ == fail_at_) {
      throw std::runtime_error("told to, \xff");  // no valid UTF-8, as external texts may be
    }
  }

  void reset() override { tick_ = 0; }

 private:
  Robot* robot_ = nullptr;
  FootbotWheels* wheels_ = nullptr;
  std::int64_t fail_at_ = -1;
  bool talks_ = false;
  std::int64_t tick_ = 0;
};

}  // namespace swarmanoid::test

REGISTER_CONTROLLER(swarmanoid::test::FailingController, "failing_controller")

// A controller for tests of the program: drives straight on, and throws in one tick if it is told to.
#include <stdexcept>

#include "swarmanoid_interface/controller.hpp"
#include "swarmanoid_interface/devices/footbot_wheels.hpp"

namespace swarmanoid::test {

class FailingController final : public Controller {
 public:
  void init(Robot& robot, const Configuration& parameters) override {
    wheels_ = &robot.actuator<FootbotWheels>();
    fail_at_ = parameters.integer("fail_at", std::int64_t{-1});
    parameters.refuseUnread({"fail_at"});
  }

  void step(Time, Duration) override {
    wheels_->setAngularVelocity(1.0, 1.0);
    if (tick_++ == fail_at_) {
      throw std::runtime_error("told to, \xff");  // no valid UTF-8, as texts from outside may be
    }
  }

  void reset() override { tick_ = 0; }

 private:
  FootbotWheels* wheels_ = nullptr;
  std::int64_t fail_at_ = -1;
  std::int64_t tick_ = 0;
};

}  // namespace swarmanoid::test

REGISTER_CONTROLLER(swarmanoid::test::FailingController, "failing_controller")

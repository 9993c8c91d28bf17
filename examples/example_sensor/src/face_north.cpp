// Face north: turns until the compass says that north is ahead, then stops.
#include <algorithm>

#include "example_sensor/compass.hpp"
#include "swarmanoid_interface/controller.hpp"
#include "swarmanoid_interface/devices/footbot_wheels.hpp"

class FaceNorth final : public swarmanoid::Controller {
 public:
  void init(swarmanoid::Robot& robot, const swarmanoid::Configuration& parameters) override {
    wheels_ = &robot.actuator<swarmanoid::FootbotWheels>();
    compass_ = &robot.sensor<Compass>();
    parameters.refuseUnread();
  }

  void step(swarmanoid::Time, swarmanoid::Duration) override {
    constexpr double kGain = 5.0;     // 1/s
    constexpr double kFastest = 5.0;  // rad/s
    const double turn = std::clamp(kGain * compass_->north, -kFastest, kFastest);
    wheels_->setAngularVelocity(-turn, turn);
  }

  void archive(swarmanoid::StateArchive&) override {}

 private:
  swarmanoid::FootbotWheels* wheels_ = nullptr;
  const Compass* compass_ = nullptr;
};

REGISTER_CONTROLLER(FaceNorth, "face_north")

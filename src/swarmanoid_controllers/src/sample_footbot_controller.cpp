// The controller of thesis 4.1.2: drives a circle. With proximity sensors it also turns on the spot near obstacles.
#include "differential_drive.hpp"
#include "swarmanoid_interface/controller.hpp"

namespace swarmanoid {

class SampleFootbotController final : public Controller {
 public:
  void init(Robot& robot, const Configuration& parameters) override {
    wheels_ = &robot.actuator<FootbotWheels>();
    if (robot.hasSensor(FootbotProximity::kType)) {
      proximity_ = &robot.sensor<FootbotProximity>();
    }
    // the thesis gives distances in cm and speeds in rad/s
    min_distance_ = 0.01 * parameters.number("min_distance", 0.0, {0.0, 10.0});
    speed_ = parameters.number("wheels_speed", 0.628, {0.0, 20.0});
    parameters.refuseUnread({"min_distance", "wheels_speed"});
  }

  void step(Time, Duration) override {
    if (proximity_ != nullptr && nearestDistance() < min_distance_) {
      wheels_->setAngularVelocity(speed_, -speed_);
    } else {
      wheels_->setAngularVelocity(0.5 * speed_, speed_);
    }
  }

  void archive(StateArchive& /*state*/) override {}

 private:
  /// Returns the distance of the nearest obstacle ahead, from the sensors' cubic response [m]; without one, their
  /// range.
  double nearestDistance() const {
    constexpr double kRange = 0.1;
    constexpr std::size_t kAhead = 4;
    double strongest = 0.0;
    for (std::size_t i = 0; i < kAhead; ++i) {
      const std::size_t other_side = (FootbotProximity::kCount - i) % FootbotProximity::kCount;
      strongest = std::max<double>({strongest, proximity_->value[i], proximity_->value[other_side]});
    }
    return kRange * (1.0 - std::cbrt(strongest));
  }

  FootbotWheels* wheels_ = nullptr;
  const FootbotProximity* proximity_ = nullptr;
  double min_distance_ = 0.0;  // m
  double speed_ = 0.0;         // rad/s
};

}  // namespace swarmanoid

REGISTER_CONTROLLER(swarmanoid::SampleFootbotController, "sample_footbot_controller")

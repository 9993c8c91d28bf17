// Phototaxis: the robot turns towards the light and drives there. In the dark it stands still; a lamp straight above
// counts as dark, because the sensors face sideways. For footbots, and for any robot with a differential drive,
// proximity sensors and light sensors.
#include "differential_drive.hpp"
#include "swarmanoid_interface/controller.hpp"
#include "swarmanoid_interface/devices/light.hpp"

namespace swarmanoid {

class Phototaxis final : public Controller {
 public:
  void init(Robot& robot, const Configuration& parameters) override {
    base_ = MobileBase(robot);
    light_ = &robot.sensor<Light>();
    speed_ = parameters.number("speed", 0.15, {0.0, 0.3});
    threshold_ = parameters.number("threshold", 0.05, {0.0, 10.0});
    parameters.refuseUnread({"speed", "threshold"});
  }

  void step(Time, Duration) override {
    constexpr double kDark = 1e-4;      // length of the sum of the readings as vectors
    constexpr double kHalfField = 0.6;  // rad: robots beside do not block the way
    double x = 0.0;
    double y = 0.0;
    for (const LightReading& sensor : light_->sensors) {
      x += sensor.value * std::cos(static_cast<double>(sensor.angle));
      y += sensor.value * std::sin(static_cast<double>(sensor.angle));
    }
    if (std::hypot(x, y) < kDark) {
      return base_.drive(0.0, 0.0);
    }
    // robots ahead drive to the same lamp, so waiting is enough and no detour is needed
    const bool is_barred = base_.obstacles(kHalfField).length() > threshold_;
    steer(base_, std::atan2(y, x), is_barred ? 0.0 : speed_);
  }

  void archive(StateArchive& /*state*/) override {}

 private:
  MobileBase base_;
  const Light* light_ = nullptr;
  double speed_ = 0.0;      // m/s
  double threshold_ = 0.0;  // length of the obstacle vector
};

}  // namespace swarmanoid

REGISTER_CONTROLLER(swarmanoid::Phototaxis, "phototaxis")

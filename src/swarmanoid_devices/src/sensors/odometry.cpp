// The odometry of any robot with a differential drive, with random wheel slip if configured.
#include "swarmanoid_interface/devices/odometry.hpp"

#include <cmath>

#include "wheel_turn_sensor.hpp"

namespace swarmanoid::devices {
namespace {

class OdometrySensor final : public WheelTurnSensor<OdometrySensor, Odometry> {
  using Base = WheelTurnSensor<OdometrySensor, Odometry>;

 public:
  static PluginDescription describe() {
    PluginDescription description = describeCounter("Position and heading, integrated along arcs.");
    description.parameters.push_back(number("slip", "m", "0", {0.0, 1.0},
                                            "Standard deviation of the rolled distance of a wheel after 1 m, beside "
                                            "slip in the engine; it grows with the square root of the distance."));
    description.parameters.push_back(
        number("assumed_slip", "m", "0.01", {0.0, 1.0}, "The value of `slip` that the covariance assumes."));
    return description;
  }

  void configure(const Configuration& parameters) override {
    Base::configure(parameters);
    slip_ = parameters.number("slip", 0.0);
    constexpr double kUsual = 0.01;  // [m]
    assumed_slip_ = parameters.number("assumed_slip", kUsual);
  }

  void count(const Space& space, Instance& instance, const WheelTurns& /*turned*/, const WheelTurns& step,
             double dt) const {
    instance.random.startTick(space.tick);
    const Odometry::Way left = wayOf(instance, step.left);
    const Odometry::Way right = wayOf(instance, step.right);
    instance.state.roll(left, right, instance.wheels.separation, dt);
  }

 private:
  /// @param turn of the wheel [rad]
  Odometry::Way wayOf(Instance& instance, double turn) const {
    Odometry::Way way{turn * instance.wheels.radius, 0.0};
    const double rolled = std::abs(way.length);
    way.variance = assumed_slip_ * assumed_slip_ * rolled;
    if (slip_ > 0.0 && rolled > 0.0) {
      way.length += instance.random.gaussian(0.0, slip_ * std::sqrt(rolled));
    }
    return way;
  }

  double slip_ = 0.0;
  double assumed_slip_ = 0.0;
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_SENSOR(swarmanoid::devices::OdometrySensor)

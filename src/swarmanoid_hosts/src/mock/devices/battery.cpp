// The battery of a mock robot: a footbot's, which is drained by the electronics and, faster, by motion. It never runs
// empty: mock robots are always on.
#include "swarmanoid_interface/devices/battery.hpp"

#include <algorithm>

#include "../mock_device.hpp"

namespace swarmanoid::mock {
namespace {

class MockBattery final : public MockDevice {
 public:
  MockBattery(Battery& readings, MockState& /*state*/) : readings_(readings) {
    readings_.capacity = kCapacity;
    readings_.voltage = 3.7F;
    write(kStandby);
  }

  void follow(MockState& state) override { moves_ = !state.twist.linear.isZero() || state.twist.yaw_rate != 0.0; }

  void act(MockState& /*state*/, double dt) override {
    const double power = kStandby + (moves_ ? kMotion : 0.0);
    charge_ = std::max(0.0, charge_ - power * dt);
    write(power);
  }

 private:
  static constexpr float kCapacity = 133200.0F;  // J
  static constexpr double kStandby = 3.2;        // W
  static constexpr double kMotion = 4.0;         // W

  void write(double power) {
    readings_.charge = static_cast<float>(charge_);
    readings_.power = static_cast<float>(power);
  }

  Battery& readings_;
  double charge_ = kCapacity;
  bool moves_ = false;  // as of the last motion
};

REGISTER_MOCK_DEVICE(Battery, MockBattery)

}  // namespace
}  // namespace swarmanoid::mock

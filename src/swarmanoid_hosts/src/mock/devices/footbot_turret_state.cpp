// The encoder of a footbot's turret.
#include "../mock_device.hpp"
#include "swarmanoid_interface/devices/footbot_turret.hpp"

namespace swarmanoid::mock {
namespace {

class MockFootbotTurretState final : public MockDevice {
 public:
  MockFootbotTurretState(FootbotTurretState& readings, MockState& /*state*/) : readings_(readings) {}

  void sense(const MockState& state) override {
    const Joint turret = state.joint("turret");
    readings_ = {turret.angle, turret.speed, 0.0};
  }

 private:
  FootbotTurretState& readings_;
};

REGISTER_MOCK_DEVICE(FootbotTurretState, MockFootbotTurretState)

}  // namespace
}  // namespace swarmanoid::mock

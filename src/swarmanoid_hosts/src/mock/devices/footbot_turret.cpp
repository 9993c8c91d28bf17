// A footbot's turret turns to an angle, or at a speed; a passive one does not turn.
#include "swarmanoid_interface/devices/footbot_turret.hpp"

#include "../mock_device.hpp"
#include "../motor.hpp"

namespace swarmanoid::mock {
namespace {

class MockFootbotTurret final : public MockDevice {
 public:
  MockFootbotTurret(const FootbotTurret& command, MockState& /*state*/) : command_(command) {}

  void act(MockState& state, double dt) override {
    turnByMotor(command_, FootbotTurret::kFastest, dt, state.joints["turret"]);
  }

 private:
  const FootbotTurret& command_;
};

REGISTER_MOCK_DEVICE(FootbotTurret, MockFootbotTurret)

}  // namespace
}  // namespace swarmanoid::mock

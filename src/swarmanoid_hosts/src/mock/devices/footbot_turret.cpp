// A footbot's turret turns to an angle, or at a speed; nothing turns a passive one.
#include "swarmanoid_interface/devices/footbot_turret.hpp"

#include "../mock_device.hpp"
#include "swarmanoid_interface/angle.hpp"

namespace swarmanoid::mock {
namespace {

class MockFootbotTurret final : public MockDevice {
 public:
  MockFootbotTurret(const FootbotTurret& command, MockState& /*state*/) : command_(command) {}

  void act(MockState& state, double dt) override {
    Joint& turret = state.joints["turret"];
    double way = 0.0;
    if (command_.mode == FootbotTurret::Mode::kAngle) {
      way = wrapAngle(command_.angle - turret.angle);
    } else if (command_.mode == FootbotTurret::Mode::kSpeed) {
      way = command_.speed * dt;
    }
    turret.turn(way, FootbotTurret::kFastest, dt);
    turret.angle = wrapAngle(turret.angle);
  }

 private:
  const FootbotTurret& command_;
};

REGISTER_MOCK_DEVICE(FootbotTurret, MockFootbotTurret)

}  // namespace
}  // namespace swarmanoid::mock

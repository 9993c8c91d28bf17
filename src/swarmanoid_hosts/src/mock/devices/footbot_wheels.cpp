// A footbot's wheels drive it over flat ground, and through walls.
#include "swarmanoid_interface/devices/footbot_wheels.hpp"

#include <algorithm>

#include "../mock_device.hpp"

namespace swarmanoid::mock {
namespace {

class MockFootbotWheels final : public MockDevice {
 public:
  MockFootbotWheels(const FootbotWheels& command, MockState& /*state*/) : command_(command) {}

  void act(MockState& state, double /*dt*/) override {
    FootbotWheels wheels = command_;
    wheels.left = std::clamp(wheels.left, -FootbotWheels::kFastest, FootbotWheels::kFastest);
    wheels.right = std::clamp(wheels.right, -FootbotWheels::kFastest, FootbotWheels::kFastest);
    state.twist.linear = {wheels.speed(), 0.0, 0.0};
    state.twist.yaw_rate = wheels.turnRate();
  }

 private:
  const FootbotWheels& command_;
};

REGISTER_MOCK_DEVICE(FootbotWheels, MockFootbotWheels)

}  // namespace
}  // namespace swarmanoid::mock

// An eyebot flies with the commanded velocity, between ground and ceiling.
#include "swarmanoid_interface/devices/eyebot_velocity.hpp"

#include <algorithm>

#include "../mock_device.hpp"
#include "swarmanoid_interface/devices/eyebot_magnet.hpp"

namespace swarmanoid::mock {
namespace {

class MockEyebotVelocity final : public MockDevice {
 public:
  MockEyebotVelocity(const EyebotVelocity& command, MockState& state) : command_(command) {
    constexpr double kUsualAltitude = 1.5;  // [m]
    state.pose.position.z() = kUsualAltitude;
    state.top = state.world.ceiling - EyebotMagnet::kMount;
  }

  void act(MockState& state, double /*dt*/) override {
    if (state.flies_to_place) {
      return;
    }
    constexpr double kFastestTurn = EyebotVelocity::kUsualFastestTurn;
    state.twist.linear = command_.linear;
    const double speed = command_.linear.stableNorm();
    if (speed > EyebotVelocity::kUsualFastest) {
      state.twist.linear *= EyebotVelocity::kUsualFastest / speed;
    }
    state.twist.yaw_rate = std::clamp(command_.yaw_rate, -kFastestTurn, kFastestTurn);
  }

 private:
  const EyebotVelocity& command_;
};

REGISTER_MOCK_DEVICE(EyebotVelocity, MockEyebotVelocity)

}  // namespace
}  // namespace swarmanoid::mock

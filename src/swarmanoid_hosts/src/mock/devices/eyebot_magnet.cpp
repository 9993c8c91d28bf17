// An eyebot's magnet holds on to the ceiling, which is ferromagnetic.
#include "swarmanoid_interface/devices/eyebot_magnet.hpp"

#include "../mock_device.hpp"

namespace swarmanoid::mock {
namespace {

class MockEyebotMagnet final : public MockDevice {
 public:
  MockEyebotMagnet(const EyebotMagnet& command, MockState& /*state*/) : command_(command) {}

  void act(MockState& state, double /*dt*/) override {
    constexpr double kTouch = 1e-3;  // [m]
    const bool is_at_ceiling = state.pose.position.z() >= state.world.ceiling - EyebotMagnet::kMount - kTouch;
    Holder& magnet = state.holders["magnet"];
    magnet.is_holding = command_.on && (magnet.is_holding || is_at_ceiling);
    state.is_fixed = magnet.is_holding;
  }

 private:
  const EyebotMagnet& command_;
};

REGISTER_MOCK_DEVICE(EyebotMagnet, MockEyebotMagnet)

}  // namespace
}  // namespace swarmanoid::mock

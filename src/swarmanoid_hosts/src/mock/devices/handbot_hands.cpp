// A handbot's hand grips an object when its arm is level, if the world has an object there.
#include "swarmanoid_interface/devices/handbot_hands.hpp"

#include <cmath>

#include "../mock_device.hpp"

namespace swarmanoid::mock {
namespace {

class MockHandbotHands final : public MockDevice {
 public:
  MockHandbotHands(const HandbotHands& command, MockState& /*state*/) : command_(command) {}

  void follow(MockState& state) override {
    hold(state, "left", command_.left, state.world.is_something_left);
    hold(state, "right", command_.right, state.world.is_something_right);
  }

 private:
  static void hold(MockState& state, const std::string& side, bool is_on, bool is_something) {
    constexpr double kLevel = 0.1;  // [rad] of the shoulder: the arm counts as stretched out
    constexpr double kForce = 5.0;  // [N]
    Holder& hand = state.holders[side + " hand"];
    const bool reaches = std::abs(state.joint(side + "_shoulder").angle) < kLevel;
    hand.is_holding = is_on && is_something && (hand.is_holding || reaches);
    hand.force = hand.is_holding ? kForce : 0.0;
  }

  const HandbotHands& command_;
};

REGISTER_MOCK_DEVICE(HandbotHands, MockHandbotHands)

}  // namespace
}  // namespace swarmanoid::mock

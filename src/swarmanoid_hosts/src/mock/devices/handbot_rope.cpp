// A handbot's rope flies up to the ceiling, and lifts the robot as it is wound in.
#include "swarmanoid_interface/devices/handbot_rope.hpp"

#include <algorithm>

#include "../mock_device.hpp"

namespace swarmanoid::mock {
namespace {

class MockHandbotRope final : public MockDevice {
 public:
  MockHandbotRope(const HandbotRope& command, MockState& /*state*/) : command_(command) {}

  void act(MockState& state, double dt) override {
    constexpr double kFlight = 0.5;  // [s] to the ceiling
    constexpr double kFall = 1.0;    // [m/s]
    Holder& rope = state.holders["rope"];
    if (!command_.shot) {
      flown_ = 0.0;
      rope = Holder{};
      state.twist.linear.z() = -kFall;
      return;
    }
    flown_ += dt;
    state.twist.linear.z() = 0.0;
    if (flown_ >= kFlight) {
      hang(state, rope, dt);
    }
  }

 private:
  void hang(MockState& state, Holder& rope, double dt) const {
    constexpr double kFastest = HandbotRope::kUsualFastest;
    constexpr double kWeight = 28.4;  // [N]
    const double height = state.pose.position.z();
    const double longest = state.world.ceiling - HandbotRope::kMount;
    if (!rope.is_holding) {
      rope.is_holding = true;
      rope.length = longest - height;
    }
    rope.length = std::max(0.0, rope.length - std::clamp(command_.winding_speed, -kFastest, kFastest) * dt);
    const double hangs_at = std::max(0.0, longest - rope.length);
    state.twist.linear.z() = dt > 0.0 ? (hangs_at - height) / dt : 0.0;
    rope.force = hangs_at > 0.0 ? kWeight : 0.0;
  }

  const HandbotRope& command_;
  double flown_ = 0.0;  // [s] since the rope was shot
};

REGISTER_MOCK_DEVICE(HandbotRope, MockHandbotRope)

}  // namespace
}  // namespace swarmanoid::mock

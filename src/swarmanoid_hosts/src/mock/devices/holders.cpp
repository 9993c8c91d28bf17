// The holders of any robot always have an object within reach: they grip and release it at once.
#include "swarmanoid_interface/devices/holders.hpp"

#include <algorithm>

#include "../mock_device.hpp"

namespace swarmanoid::mock {
namespace {

class MockHolders final : public MockDevice {
 public:
  MockHolders(const Holders& command, MockState& /*state*/) : command_(command) {}

  void act(MockState& state, double dt) override {
    for (std::size_t i = 0; i < state.world.holders.count; ++i) {
      hold(command_.holders[i], state.world.holders.rope, dt, state.holders[World::Holders::name(i)]);
    }
  }

 private:
  /// @param rope length of the rope [m]; 0: there is none
  static void hold(const Holders::Holder& command, double rope, double dt, Holder& holder) {
    constexpr double kForce = 5.0;  // [N]
    constexpr double kFastest = Holders::kUsualFastest;
    if (!command.holds) {
      holder = Holder{};
      return;
    }
    const double before = holder.is_holding ? holder.length : rope;
    const double wound = std::clamp(command.winding_speed, -kFastest, kFastest) * dt;
    holder.length = std::clamp(before - wound, 0.0, rope);
    holder.is_holding = true;
    holder.force = kForce;
  }

  const Holders& command_;
};

REGISTER_MOCK_DEVICE(Holders, MockHolders)

}  // namespace
}  // namespace swarmanoid::mock

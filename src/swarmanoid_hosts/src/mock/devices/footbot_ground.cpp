// A footbot's ground sensors read the discs on the floor of the world.
#include "swarmanoid_interface/devices/footbot_ground.hpp"

#include "../mock_device.hpp"

namespace swarmanoid::mock {
namespace {

/// @tparam Spots a device with `value` and `place`
template <class Spots>
class MockFootbotSpots final : public MockDevice {
 public:
  MockFootbotSpots(Spots& readings, MockState& /*state*/) : readings_(readings) {}

  void sense(const MockState& state) override {
    for (std::size_t i = 0; i < Spots::kCount; ++i) {
      readings_.value[i] = reflectionUnder(state.world, state.pose, Spots::place(i));
    }
  }

 private:
  Spots& readings_;
};

REGISTER_MOCK_DEVICE(FootbotGround, MockFootbotSpots<FootbotGround>)
REGISTER_MOCK_DEVICE(FootbotBaseGround, MockFootbotSpots<FootbotBaseGround>)

}  // namespace
}  // namespace swarmanoid::mock

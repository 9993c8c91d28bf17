// The cups of a handbot's hand are closed while the hand holds an object.
#include "swarmanoid_interface/devices/handbot_vacuum.hpp"

#include "../mock_device.hpp"

namespace swarmanoid::mock {
namespace {

class MockHandbotVacuum final : public MockDevice {
 public:
  MockHandbotVacuum(HandbotVacuum& readings, MockState& /*state*/) : readings_(readings) {}

  void sense(const MockState& state) override {
    constexpr std::size_t kCups = 2;  // of a hand
    for (std::size_t i = 0; i < kCups; ++i) {
      readings_.left[i] = state.holder("left hand").is_holding ? 1.0F : 0.0F;
      readings_.right[i] = state.holder("right hand").is_holding ? 1.0F : 0.0F;
    }
  }

 private:
  HandbotVacuum& readings_;
};

REGISTER_MOCK_DEVICE(HandbotVacuum, MockHandbotVacuum)

}  // namespace
}  // namespace swarmanoid::mock

// A footbot's LEDs: nobody looks at them, but drivers publish their colours.
#include "../mock_device.hpp"
#include "swarmanoid_interface/devices/leds.hpp"

namespace swarmanoid::mock {
namespace {

class MockFootbotLeds final : public MockDevice {
 public:
  MockFootbotLeds(const FootbotLeds& /*command*/, MockState& /*state*/) {}

  bool isShown() const override { return true; }
};

REGISTER_MOCK_DEVICE(FootbotLeds, MockFootbotLeds)

}  // namespace
}  // namespace swarmanoid::mock

// An eyebot's LEDs: nobody looks at them, but drivers publish their colours.
#include "../mock_device.hpp"
#include "swarmanoid_interface/devices/leds.hpp"

namespace swarmanoid::mock {
namespace {

class MockEyebotLeds final : public MockDevice {
 public:
  MockEyebotLeds(const EyebotLeds& /*command*/, MockState& /*state*/) {}

  bool isShown() const override { return true; }
};

REGISTER_MOCK_DEVICE(EyebotLeds, MockEyebotLeds)

}  // namespace
}  // namespace swarmanoid::mock

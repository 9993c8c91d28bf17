// LEDs of any robot, and the rings of footbots, eyebots and handbots: no mock device sees them, but drivers publish
// their colours.
#include "swarmanoid_interface/devices/leds.hpp"

#include "../mock_device.hpp"
#include "swarmanoid_interface/devices/handbot_leds.hpp"
#include "swarmanoid_interface/devices/led_array.hpp"

namespace swarmanoid::mock {
namespace {

template <class Device>
class MockLeds final : public MockDevice {
 public:
  MockLeds(const Device& /*command*/, MockState& /*state*/) {}

  bool isShown() const override { return true; }
};

REGISTER_MOCK_DEVICE(EyebotLeds, MockLeds<EyebotLeds>)
REGISTER_MOCK_DEVICE(FootbotLeds, MockLeds<FootbotLeds>)
REGISTER_MOCK_DEVICE(HandbotLeds, MockLeds<HandbotLeds>)
REGISTER_MOCK_DEVICE(Leds, MockLeds<Leds>)

}  // namespace
}  // namespace swarmanoid::mock

// The WiFi receiver of any robot: messages and their senders.
#include "radio_receiver.hpp"
#include "swarmanoid_interface/devices/wifi.hpp"

namespace swarmanoid::devices {
namespace {

class WifiReceiver final : public RadioReceiver<WifiReceived, Wifi> {
 public:
  static PluginDescription describe() {
    return describeReceiver("Hears who sends in range, those who are near rather than those who are far.");
  }
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_SENSOR(swarmanoid::devices::WifiReceiver)

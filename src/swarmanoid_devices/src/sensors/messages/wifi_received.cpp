// The WiFi receiver of any robot: messages and their senders.
#include "radio_receiver.hpp"
#include "swarmanoid_interface/devices/wifi.hpp"

namespace swarmanoid::devices {
namespace {

class WifiReceiver final : public RadioReceiver<WifiReceived, Wifi> {
 public:
  static PluginDescription describe() {
    return describeReceiver("Receives messages of senders in range, near ones more reliably than far ones.");
  }
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_SENSOR(swarmanoid::devices::WifiReceiver)

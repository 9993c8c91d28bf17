// The WiFi sender of any robot.
#include "swarmanoid_interface/devices/wifi.hpp"

#include "message_sender.hpp"

namespace swarmanoid::devices {
namespace {

class WifiSender final : public MessageSender<Wifi> {
 public:
  static PluginDescription describe() {
    return describeSender("Sends its payload to all robots around, or to one, in each tick until it falls silent.");
  }
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_ACTUATOR(swarmanoid::devices::WifiSender)

// The Bluetooth sender of any robot.
#include "swarmanoid_interface/devices/bluetooth.hpp"

#include "message_sender.hpp"

namespace swarmanoid::devices {
namespace {

class BluetoothSender final : public MessageSender<Bluetooth> {
 public:
  static PluginDescription describe() {
    return describeSender("Sends its payload to all robots near, or to one, in each tick until it falls silent.");
  }
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_ACTUATOR(swarmanoid::devices::BluetoothSender)

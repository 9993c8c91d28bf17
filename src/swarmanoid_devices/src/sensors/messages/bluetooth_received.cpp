// The Bluetooth receiver of any robot: messages and their senders.
#include "radio_receiver.hpp"
#include "swarmanoid_interface/devices/bluetooth.hpp"

namespace swarmanoid::devices {
namespace {

class BluetoothReceiver final : public RadioReceiver<BluetoothReceived, Bluetooth> {
 public:
  static PluginDescription describe() {
    return describeReceiver("Hears who sends in range, those who are near rather than those who are far.");
  }
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_SENSOR(swarmanoid::devices::BluetoothReceiver)

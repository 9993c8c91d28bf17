// The Bluetooth receiver of any robot: messages and their senders.
#include "radio_receiver.hpp"
#include "swarmanoid_interface/devices/bluetooth.hpp"

namespace swarmanoid::devices {
namespace {

class BluetoothReceiver final : public RadioReceiver<BluetoothReceived, Bluetooth> {
 public:
  static PluginDescription describe() {
    return describeReceiver("Receives messages of senders in range, near ones more reliably than far ones.");
  }
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_SENSOR(swarmanoid::devices::BluetoothReceiver)

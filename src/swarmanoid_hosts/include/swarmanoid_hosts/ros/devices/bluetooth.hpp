/// Defines the topics of devices/bluetooth.hpp.
#pragma once

#include "swarmanoid_hosts/ros/devices/radio.hpp"
#include "swarmanoid_interface/devices/bluetooth.hpp"

namespace swarmanoid {

REGISTER_DEVICE_TOPIC(Bluetooth, swarmanoid_msgs::RadioCommand, kCommand, "bluetooth/command")
REGISTER_DEVICE_TOPIC(BluetoothReceived, swarmanoid_msgs::RadioMessages, kReading, "bluetooth/received", "base_link")

}  // namespace swarmanoid

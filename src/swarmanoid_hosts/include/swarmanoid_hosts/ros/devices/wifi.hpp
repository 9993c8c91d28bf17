/// Defines the topics of devices/wifi.hpp.
#pragma once

#include "swarmanoid_hosts/ros/devices/radio.hpp"
#include "swarmanoid_interface/devices/wifi.hpp"

namespace swarmanoid {

REGISTER_DEVICE_TOPIC(Wifi, swarmanoid_msgs::RadioCommand, kCommand, "wifi/command")
REGISTER_DEVICE_TOPIC(WifiReceived, swarmanoid_msgs::RadioMessages, kReading, "wifi/received", "base_link")

}  // namespace swarmanoid

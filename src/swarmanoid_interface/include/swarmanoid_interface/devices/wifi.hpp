/// Actuator and sensor: WiFi, for larger messages between robots over a long range, through obstacles too (thesis 1:
/// "wireless communication in two fashions"). Any robot may have it.
#pragma once

#include "swarmanoid_interface/devices/radio.hpp"

namespace swarmanoid {

/// The antenna sits at the link `wifi` of the robot's description, or, if it has none, over its origin in the middle of
/// its height.
struct Wifi : RadioCommand<128> {
  static constexpr const char* kType = "wifi";
  static constexpr const char* kLink = "wifi";
};
REGISTER_DEVICE_OF_SUITE(Wifi, kActuator, "WiFi that sends a message to all robots around, or to one of them.")

using WifiMessage = RadioMessage<Wifi::kBytes>;

struct WifiReceived : ReceivedMessages<WifiMessage> {
  static constexpr const char* kType = "wifi_received";
  /// Maximum range between antennas: that of IEEE 802.11g in the open; in buildings it is 30 m [m].
  static constexpr double kUsualRange = 100.0;
  static constexpr bool kNeedsSight = false;
  static constexpr bool kSharesChannel = true;
  /// Packet loss allowed at the receiver's minimum sensitivity (IEEE Std 802.11-2016, 17.3.10.2).
  static constexpr double kUsualLossAtRange = 0.1;
};
REGISTER_DEVICE_OF_SUITE(WifiReceived, kSensor, "Messages that came by WiFi, with the address of each sender.")

}  // namespace swarmanoid

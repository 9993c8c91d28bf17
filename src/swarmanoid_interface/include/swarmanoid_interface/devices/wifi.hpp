/// Actuator and sensor: WiFi, with which robots exchange larger messages over a long range, whatever stands between
/// them (thesis 1: "wireless communication in two fashions"). Any robot may have it.
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
  /// Between antennas, beyond which it hears nothing: IEEE 802.11g in the open; in buildings it is 30 m [m].
  static constexpr double kUsualRange = 100.0;
  static constexpr bool kNeedsSight = false;
  static constexpr bool kSharesChannel = true;
  /// What a receiver may lose where signals are as weak as it takes them (IEEE Std 802.11-2016, 17.3.10.2).
  static constexpr double kUsualLossAtRange = 0.1;
};
REGISTER_DEVICE_OF_SUITE(WifiReceived, kSensor, "Messages that came by WiFi, with the address of each sender.")

}  // namespace swarmanoid

/// Actuator and sensor: Bluetooth, for short messages between robots near each other, through obstacles too (thesis 1:
/// "short range inter-robot communication"). Any robot may have it.
#pragma once

#include "swarmanoid_interface/devices/radio.hpp"

namespace swarmanoid {

/// The bytes are those of the smallest data packet, DH1 (Bluetooth Core Specification 2.0, volume 2, part B, 6.5.4).
/// The antenna sits at the link `bluetooth` of the robot's description, or, if it has none, over its origin in the
/// middle of its height.
struct Bluetooth : RadioCommand<27> {
  static constexpr const char* kType = "bluetooth";
  static constexpr const char* kLink = "bluetooth";
};
REGISTER_DEVICE_OF_SUITE(Bluetooth, kActuator,
                         "Bluetooth that sends a short message to all robots near, or to one of them.")

using BluetoothMessage = RadioMessage<Bluetooth::kBytes>;

struct BluetoothReceived : ReceivedMessages<BluetoothMessage> {
  static constexpr const char* kType = "bluetooth_received";
  static constexpr std::size_t kMostMessages = 7;  ///< maximum number of active slaves in a piconet
  static constexpr double kUsualRange = 10.0;      ///< maximum range between antennas, of class 2 [m]
  static constexpr bool kNeedsSight = false;
  static constexpr bool kSharesChannel = true;
  /// Each of the 240 bits of such a packet is wrong with a probability of 0.001 at the receiver's sensitivity level
  /// (the same specification, part A, 4.1): 1 - 0.999^240.
  static constexpr double kUsualLossAtRange = 0.2;
};
REGISTER_DEVICE_OF_SUITE(BluetoothReceived, kSensor,
                         "Messages that came by Bluetooth, with the address of each sender.")

}  // namespace swarmanoid

/// Sensor: the difference of the air pressure to that where an eyebot took off (thesis chapter 1: "a differential
/// pressure sensor").
#pragma once

#include <cmath>

#include "swarmanoid_interface/device_type.hpp"

namespace swarmanoid {

/// The pressure falls by about 12 Pa per metre. It gives the height everywhere, over holes and other robots too.
struct EyebotPressure {
  static constexpr const char* kType = "eyebot_pressure";
  static constexpr const char* kRobot = "eyebot";

  double difference = 0.0;  ///< to the pressure at the height of the start; less than 0 above it [Pa]

  // Standard atmosphere at sea level (ISO 2533:1975); the height of the robot's start is taken as sea level.
  static constexpr double kPressure = 101325.0;      ///< [Pa]
  static constexpr double kTemperature = 288.15;     ///< [K]
  static constexpr double kLapseRate = 0.0065;       ///< [K/m]
  static constexpr double kGravity = 9.80665;        ///< [m/s2]
  static constexpr double kGasConstant = 287.05287;  ///< of dry air [J/(kg K)]

  /// The law of the barometric formula in the troposphere. @param height over the start [m]
  static double differenceAt(double height) {
    return kPressure *
           std::expm1(kGravity / (kGasConstant * kLapseRate) * std::log1p(-kLapseRate * height / kTemperature));
  }
};

template <class Visitor>
void fields(Visitor& visit, EyebotPressure& pressure) {
  visit(pressure.difference, {"difference", "Pa", "to that at the start; less than 0 above it"});
}
REGISTER_DEVICE_OF_SUITE(EyebotPressure, kSensor, "Pressure of the air against that where it took off.")

}  // namespace swarmanoid

/// The power supply and consumption of robots of a type: <battery> and <consumption> of their descriptions. A robot has
/// a battery if the experiment says so, <battery>true</battery>; without one it never runs out of energy.
///
/// The law and the numbers of the suite's robots, most of them estimates, are in docs/reference/battery.md.
#pragma once

#include <map>
#include <string>

#include "swarmanoid_interface/range.hpp"

namespace swarmanoid {

/// Stores and charging power of a robot: properties of robots with a battery, in this order.
enum BatteryProperty : std::size_t { kBatteryCharge, kBatteryCapacitor, kBatterySupply };

/// Names of these properties, also of the corresponding ones of arena objects.
constexpr const char* kCharge = "charge";        ///< of the battery [J]
constexpr const char* kCapacitor = "capacitor";  ///< of the super-capacitor, which bridges an empty battery [J]
constexpr const char* kSupply = "supply";        ///< charging power [W]
constexpr Range kChargeRange{0.0, 1e9};          ///< [J]
constexpr Range kCapacityRange{1e-6, 1e9};       ///< of batteries of robots [J]
constexpr Range kPowerRange{0.0, 1e6};           ///< [W]

struct BatteryModel {
  static constexpr double kAirDensity = 1.225;  ///< at sea level and 15 degrees Celsius [kg/m3]
  static constexpr double kGravity = 9.81;      ///< [m/s2]
  static constexpr double kRefillTime = 60.0;   ///< time in which the battery fills an empty capacitor; assumed [s]

  double capacity = 0.0;     ///< of the battery [J]
  double voltage = 0.0;      ///< nominal; constant until the battery is empty [V]
  double capacitor = 0.0;    ///< capacity of the super-capacitor; 0: none [J]
  double first_share = 1.0;  ///< initial charge, as a part of the capacity
  double enough = 0.3;       ///< charge at which an empty robot restarts, as a part of the capacity

  double electronics = 0.0;                            ///< always on [W]
  double drive = 0.0;                                  ///< both wheels at maximum speed [W]
  double stall = 0.0;                                  ///< both wheels blocked at full voltage; 0: as `drive` [W]
  double led = 0.0;                                    ///< a white LED [W]
  double flight = 0.0;                                 ///< rotors that carry the robot [W]
  std::map<std::string, double, std::less<>> devices;  ///< each device that a controller lists, by type [W]

  /// Power of a device that is on. @param device a type; types that are not in `devices` are part of the electronics
  double powerOf(const std::string& device) const {
    const auto found = devices.find(device);
    return found == devices.end() ? 0.0 : found->second;
  }
};

/// Power of hovering rotors, by momentum theory of an actuator disc: sqrt((m g)^3 / (2 rho A)) / efficiency.
/// @param mass [kg] @param area of all discs [m2], greater than 0
/// @param efficiency of rotors, motors and their electronics together
/// @return [W]
double hoverPower(double mass, double area, double efficiency);

}  // namespace swarmanoid

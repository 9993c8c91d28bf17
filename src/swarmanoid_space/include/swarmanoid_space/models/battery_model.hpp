/// What robots of a type run on, and what they use of it: <battery> and <consumption> of their descriptions. A robot
/// has a battery if the experiment says so, <battery>true</battery>; without one it runs for ever.
///
/// The law and the numbers of the suite's robots, most of them estimates, are in docs/reference/battery.md.
#pragma once

#include <map>
#include <string>

#include "swarmanoid_interface/range.hpp"

namespace swarmanoid {

/// What a robot holds and is charged with: properties of those that have a battery, in this order.
enum BatteryProperty : std::size_t { kBatteryCharge, kBatteryCapacitor, kBatterySupply };

/// The names of these, and of what arena objects hold and are charged with.
constexpr const char* kCharge = "charge";        ///< of the battery [J]
constexpr const char* kCapacitor = "capacitor";  ///< of the super-capacitor, which bridges a battery that is out [J]
constexpr const char* kSupply = "supply";        ///< at which it is charged [W]
constexpr Range kChargeRange{0.0, 1e9};          ///< [J]
constexpr Range kCapacityRange{1e-6, 1e9};       ///< of batteries of robots [J]
constexpr Range kPowerRange{0.0, 1e6};           ///< [W]

struct BatteryModel {
  static constexpr double kAirDensity = 1.225;  ///< at sea level and 15 degrees Celsius [kg/m3]
  static constexpr double kGravity = 9.81;      ///< [m/s2]
  static constexpr double kRefillTime = 60.0;   ///< of an empty capacitor, from the battery; assumed [s]

  double capacity = 0.0;     ///< the most that the battery holds [J]
  double voltage = 0.0;      ///< nominal, which it keeps until it is empty [V]
  double capacitor = 0.0;    ///< the most that the super-capacitor holds; 0: there is none [J]
  double first_share = 1.0;  ///< of the capacity that is in it at first
  double enough = 0.3;       ///< of the capacity with which a robot goes on that was empty

  double electronics = 0.0;  ///< what is always on [W]
  double drive = 0.0;        ///< of both wheels at their limit of speed [W]
  double stall = 0.0;        ///< of both at full voltage while they are held; 0: as `drive` [W]
  double led = 0.0;          ///< of a white LED [W]
  double flight = 0.0;       ///< of rotors that carry the robot [W]
  std::map<std::string, double, std::less<>> devices;  ///< of each that a controller lists, by type [W]

  /// What devices draw that are on. @param device a type; others than those of `devices` are part of the electronics
  double powerOf(const std::string& device) const {
    const auto found = devices.find(device);
    return found == devices.end() ? 0.0 : found->second;
  }
};

/// Rotors that hang still in the air, by momentum theory of an actuator disc: sqrt((m g)^3 / (2 rho A)) / efficiency.
/// @param mass [kg] @param area of all discs [m2], greater than 0
/// @param efficiency of rotors, motors and their electronics together
/// @return [W]
double hoverPower(double mass, double area, double efficiency);

}  // namespace swarmanoid

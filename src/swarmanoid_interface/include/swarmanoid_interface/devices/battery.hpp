/// Sensor: the gauge of the battery of any robot that has one.
#pragma once

#include "swarmanoid_interface/device_type.hpp"

namespace swarmanoid {

/// Readings of the gauge. The voltage is constant until the battery is empty. docs/reference/battery.md describes the
/// power that robots draw and how they are charged.
struct Battery {
  static constexpr const char* kType = "battery";

  float charge = 0.0F;        ///< remaining [J]
  float capacity = 0.0F;      ///< charge of the full battery [J]
  float voltage = 0.0F;       ///< [V]
  float power = 0.0F;         ///< drawn by the robot, minus the charging power [W]
  bool is_charging = false;   ///< a charger is connected, even if the battery is full
  bool on_capacitor = false;  ///< battery removed or empty: a super-capacitor powers the robot, with its wheels off

  /// Remaining part of the capacity: 0 to 1.
  float fraction() const { return capacity > 0.0F ? charge / capacity : 0.0F; }
  /// Current into the battery, as in sensor_msgs/BatteryState [A]; negative while it discharges.
  float current() const { return voltage > 0.0F ? -power / voltage : 0.0F; }
};

template <class Visitor>
void fields(Visitor& visit, Battery& battery) {
  visit(battery.charge, {"charge", "J", "remaining charge"});
  visit(battery.capacity, {"capacity", "J", "maximum charge"});
  visit(battery.voltage, {"voltage", "V", "of the battery"});
  visit(battery.power, {"power", "W", "that the robot draws, less that at which it is charged"});
  visit(battery.is_charging, {"is_charging", "", "a charger is connected"});
  visit(battery.on_capacitor,
        {"on_capacitor", "", "a super-capacitor alone keeps the robot alive; its wheels are off"});
}
REGISTER_DEVICE_OF_SUITE(Battery, kSensor, "State of the robot's battery.")

}  // namespace swarmanoid

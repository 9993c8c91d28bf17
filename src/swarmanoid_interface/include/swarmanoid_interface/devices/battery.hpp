/// Sensor: the battery of any robot that runs on one, as its gauge reports it.
#pragma once

#include "swarmanoid_interface/device_type.hpp"

namespace swarmanoid {

/// Readings of the gauge. The battery keeps its voltage until it is empty; what robots draw, and how they are charged,
/// is in docs/reference/battery.md.
struct Battery {
  static constexpr const char* kType = "battery";

  float charge = 0.0F;        ///< that is left [J]
  float capacity = 0.0F;      ///< the most that it holds [J]
  float voltage = 0.0F;       ///< of the battery [V]
  float power = 0.0F;         ///< that the robot draws, less that at which it is charged [W]
  bool is_charging = false;   ///< something charges it, also if it is full
  bool on_capacitor = false;  ///< it is out or has nothing left: a super-capacitor keeps the robot alive, wheels off

  /// Part of the capacity that is left: 0 to 1.
  float fraction() const { return capacity > 0.0F ? charge / capacity : 0.0F; }
  /// What flows into the battery, as sensor_msgs/BatteryState counts it [A]; negative while it is used.
  float current() const { return voltage > 0.0F ? -power / voltage : 0.0F; }
};

template <class Visitor>
void fields(Visitor& visit, Battery& battery) {
  visit(battery.charge, {"charge", "J", "that is left"});
  visit(battery.capacity, {"capacity", "J", "the most that it holds"});
  visit(battery.voltage, {"voltage", "V", "of the battery"});
  visit(battery.power, {"power", "W", "that the robot draws, less that at which it is charged"});
  visit(battery.is_charging, {"is_charging", "", "something charges it"});
  visit(battery.on_capacitor,
        {"on_capacitor", "", "a super-capacitor alone keeps the robot alive; its wheels are off"});
}
REGISTER_DEVICE_OF_SUITE(Battery, kSensor, "What is left in the robot's battery.")

}  // namespace swarmanoid

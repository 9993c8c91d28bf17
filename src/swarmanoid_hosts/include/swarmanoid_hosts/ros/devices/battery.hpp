/// Defines the topic of devices/battery.hpp, and converts its device to messages and back.
#pragma once

#include <sensor_msgs/BatteryState.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "swarmanoid_hosts/ros/device_topic.hpp"
#include "swarmanoid_interface/devices/battery.hpp"

namespace swarmanoid {

namespace detail {

/// Factor for messages, which have charge in ampere hours. @return [J / (A h)], at 1 V if there is no voltage
inline float joulesPerAmpereHour(float voltage) { return 3600.0F * (voltage > 0.0F ? voltage : 1.0F); }

}  // namespace detail

/// A battery is present unless the super-capacitor alone keeps the robot alive. Temperature, health and single cells
/// are not measured.
inline void toMessage(const Battery& readings, sensor_msgs::BatteryState& message) {
  using State = sensor_msgs::BatteryState;
  constexpr float kNotMeasured = std::numeric_limits<float>::quiet_NaN();
  const float unit = detail::joulesPerAmpereHour(readings.voltage);
  message.voltage = readings.voltage;
  message.temperature = kNotMeasured;
  message.current = readings.current();
  message.charge = readings.charge / unit;
  message.capacity = readings.capacity / unit;
  message.design_capacity = kNotMeasured;
  message.percentage = readings.fraction();
  const bool holds_all = readings.capacity > 0.0F && readings.charge >= readings.capacity;
  // a full battery is reported as such only if the sign of the current still tells whether it is being charged
  const bool is_full = holds_all && readings.is_charging == (message.current >= 0.0F);
  message.power_supply_status = is_full                ? State::POWER_SUPPLY_STATUS_FULL
                                : readings.is_charging ? State::POWER_SUPPLY_STATUS_CHARGING
                                                       : State::POWER_SUPPLY_STATUS_DISCHARGING;
  message.power_supply_health = State::POWER_SUPPLY_HEALTH_UNKNOWN;
  message.power_supply_technology = State::POWER_SUPPLY_TECHNOLOGY_LIPO;
  message.present = !readings.on_capacitor;
}

/// Other gauges may not measure the values that controllers need.
inline void fromMessage(const sensor_msgs::BatteryState& message, Battery& readings) {
  if (!(message.voltage >= 0.0F)) {
    throw std::runtime_error("found no voltage, allowed: 0 V or more");
  }
  if (std::isnan(message.charge) || std::isnan(message.capacity)) {
    throw std::runtime_error("found no charge or no capacity (NaN: not measured), allowed: both");
  }
  const float unit = detail::joulesPerAmpereHour(message.voltage);
  readings.voltage = message.voltage;
  readings.charge = message.charge * unit;
  readings.capacity = message.capacity * unit;
  readings.power = std::isnan(message.current) ? 0.0F : -message.current * message.voltage;
  using State = sensor_msgs::BatteryState;
  const bool is_full = message.power_supply_status == State::POWER_SUPPLY_STATUS_FULL;
  readings.is_charging =
      message.power_supply_status == State::POWER_SUPPLY_STATUS_CHARGING || (is_full && message.current >= 0.0F);
  readings.on_capacitor = message.present == 0;
}

REGISTER_DEVICE_TOPIC(Battery, sensor_msgs::BatteryState, kReading, "battery", "base_link")

}  // namespace swarmanoid

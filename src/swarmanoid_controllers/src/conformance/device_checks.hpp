/// The checks of a device, which register themselves while the library loads:
///
///     std::vector<Check> sonarChecks(Bench& bench) { ... }
///     const ChecksRegistration sonar_checks({Sonar::kType, sonarChecks});
///
/// A device may be registered more than once: by its own checks, and by those of a device that it observes.
#pragma once

#include <string>
#include <vector>

#include "bench.hpp"
#include "check.hpp"

namespace swarmanoid::conformance {

struct DeviceChecks {
  std::string device;  ///< Device::kType
  std::vector<Check> (*make)(Bench& bench) = nullptr;
  /// Changes what is usual at the place where robots with the device are tested; null: nothing.
  void (*prepare)(Surroundings& usual) = nullptr;
  /// Commands rest, of an actuator that moves the robot; null for others.
  void (*rest)(const Bench& bench) = nullptr;
  /// Returns the readings of a camera; null for devices that are none.
  const ColorBlobs* (*look)(const Bench& bench) = nullptr;
  /// Returns what an observer that lists the device judges of the other robot; null: nothing.
  std::vector<Check> (*observe)(Bench& bench) = nullptr;
};

/// Returns the checks of all devices, sorted by device.
const std::vector<DeviceChecks>& deviceChecks();

/// A DeviceChecks::rest: commands what the device does at rest.
template <class Device>
void restAtOnce(const Bench& bench) {
  *bench.actuator<Device>() = Device{};
}

/// A DeviceChecks::make of what has none of its own.
inline std::vector<Check> noChecks(Bench& /*bench*/) { return {}; }

/// A DeviceChecks::prepare: there is a wall, for sensors that feel it.
inline void besideWall(Surroundings& usual) { usual.wall_distance = 0.4; }

struct ChecksRegistration {
  explicit ChecksRegistration(DeviceChecks checks);
};

}  // namespace swarmanoid::conformance

/// The checks of a device, which register themselves while the library loads:
///
///     std::vector<Check> sonarChecks(Bench& bench) { ... }
///     const ChecksRegistration sonar_checks({Sonar::kType, sonarChecks});
///
/// A device may be registered several times: by its own checks, and by those of a device that it observes.
#pragma once

#include <string>
#include <vector>

#include "bench.hpp"
#include "check.hpp"

namespace swarmanoid::conformance {

struct DeviceChecks {
  std::string device;  ///< Device::kType
  std::vector<Check> (*make)(Bench& bench) = nullptr;
  /// Changes the default surroundings of robots with the device; null: no change.
  void (*prepare)(Surroundings& usual) = nullptr;
  /// Commands rest to an actuator that moves the robot; null for others.
  void (*rest)(const Bench& bench) = nullptr;
  /// Returns the readings of a camera; null for other devices.
  const ColorBlobs* (*look)(const Bench& bench) = nullptr;
  /// Returns the checks by which an observer with the device judges the other robot; null: none.
  std::vector<Check> (*observe)(Bench& bench) = nullptr;
};

/// Returns the checks of all devices, sorted by device.
const std::vector<DeviceChecks>& deviceChecks();

/// A DeviceChecks::rest: commands the default of the device, which is rest.
template <class Device>
void restAtOnce(const Bench& bench) {
  *bench.actuator<Device>() = Device{};
}

/// A DeviceChecks::make for a device without checks of its own.
inline std::vector<Check> noChecks(Bench& /*bench*/) { return {}; }

/// A DeviceChecks::prepare: adds a wall, for sensors that detect it.
inline void besideWall(Surroundings& usual) { usual.wall_distance = 0.4; }

struct ChecksRegistration {
  explicit ChecksRegistration(DeviceChecks checks);
};

}  // namespace swarmanoid::conformance

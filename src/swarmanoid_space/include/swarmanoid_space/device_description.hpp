/// Completes the descriptions of sensors and actuators with the data of their device structs.
#pragma once

#include <string>
#include <utility>

#include "swarmanoid_interface/device_type.hpp"
#include "swarmanoid_interface/registry.hpp"

namespace swarmanoid {

/// @tparam Device the struct, or void
/// @return the description with the robot type of the device, kRobot, if the struct has one
template <class Device>
PluginDescription describeDevice(PluginDescription description) {
  if (std::string robot = detail::robotOf<Device>(); !robot.empty()) {
    description.robots = {std::move(robot)};
  }
  return description;
}

}  // namespace swarmanoid

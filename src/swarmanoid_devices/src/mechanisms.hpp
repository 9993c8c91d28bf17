/// Short functions for devices that work with mechanisms of a robot.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "swarmanoid_interface/configuration.hpp"
#include "swarmanoid_interface/mechanism.hpp"
#include "swarmanoid_space/space.hpp"

namespace swarmanoid::devices {

inline Mechanism wheels() { return {Mechanism::Kind::kWheels}; }
inline Mechanism flight() { return {Mechanism::Kind::kFlight}; }
inline Mechanism joint(const std::string& name) { return {Mechanism::Kind::kJoint, name}; }
inline Mechanism holder(const std::string& name) { return {Mechanism::Kind::kHolder, name}; }

/// All joints of the names.
template <std::size_t count>
std::vector<Mechanism> joints(const std::array<const char*, count>& names) {
  std::vector<Mechanism> result;
  for (const char* name : names) {
    result.push_back(joint(name));
  }
  return result;
}

/// The indices of the joints in the model; -1 for those that it does not have.
template <std::size_t count>
std::array<int, count> indicesOf(const std::array<const char*, count>& names, const EntityModel& model) {
  std::array<int, count> result{};
  for (std::size_t i = 0; i < count; ++i) {
    result[i] = model.findJoint(names[i]);
  }
  return result;
}

/// @throws ConfigError that the device cannot be on a robot of that type, which has no such part
[[noreturn]] inline void refuseWithout(const std::string& device, const EntityModel& model, const std::string& part) {
  throw ConfigError({}, "found the device '" + device + "' on a " + model.type + ", allowed: on robots with " + part);
}

}  // namespace swarmanoid::devices

/// Short functions for devices that use mechanisms of a robot.
#pragma once

#include <array>
#include <cstddef>
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
// All joints or holders of the robot.
inline Mechanism allJoints() { return {Mechanism::Kind::kJoint}; }
inline Mechanism allHolders() { return {Mechanism::Kind::kHolder}; }

/// All joints with these names.
template <std::size_t count>
std::vector<Mechanism> joints(const std::array<const char*, count>& names) {
  std::vector<Mechanism> result;
  for (const char* name : names) {
    result.push_back(joint(name));
  }
  return result;
}

/// @throws ConfigError always: the device cannot be on a robot of that type, which lacks the part
[[noreturn]] inline void refuseWithout(const std::string& device, const EntityModel& model, const std::string& part) {
  throw ConfigError({}, "found the device '" + device + "' on a " + model.type + ", allowed: on robots with " + part);
}

/// Indices in the model of all joints, or of all holders, of a robot; the rest of the array is -1.
/// @param found number of them @param parts "joints" @throws ConfigError if `found` is 0 or more than `most`
template <std::size_t most>
std::array<int, most> allOf(const std::string& device, const EntityModel& model, std::size_t found,
                            const std::string& parts) {
  if (found == 0) {
    refuseWithout(device, model, parts);
  }
  if (found > most) {
    throw ConfigError({}, "found the device '" + device + "' on a " + model.type + " with " + std::to_string(found) +
                              " " + parts + ", allowed: on robots with 1 to " + std::to_string(most));
  }
  std::array<int, most> indices{};
  for (std::size_t i = 0; i < most; ++i) {
    indices[i] = i < found ? static_cast<int>(i) : -1;
  }
  return indices;
}

}  // namespace swarmanoid::devices

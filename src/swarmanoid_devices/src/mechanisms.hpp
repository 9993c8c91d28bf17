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

/// Commands a holder of the robot, if it has one of that name.
inline void command(Space& space, Row row, const std::string& name, bool holds, double winding_speed = 0.0) {
  const int index = space.entities.model[row]->findHolder(name);
  if (index >= 0) {
    space.holder_commands[row][static_cast<std::size_t>(index)] = {true, holds, winding_speed};
  }
}

/// What a holder of the robot holds on to; nothing if it has none of that name.
inline Attachment attachmentOf(const Space& space, Row row, const std::string& name) {
  const int index = space.entities.model[row]->findHolder(name);
  return index < 0 ? Attachment{} : space.attachments.of(row, static_cast<std::size_t>(index));
}

}  // namespace swarmanoid::devices

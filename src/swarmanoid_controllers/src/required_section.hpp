/// Elements that the parameters of a controller must have.
#pragma once

#include <string>

#include "swarmanoid_interface/configuration.hpp"

namespace swarmanoid {

/// @param key the element's tag @param user what needs it, for the message: "the network"
/// @throws ConfigError if there is none
inline const Configuration& requiredSection(const Configuration& parameters, const std::string& key,
                                            const std::string& user) {
  const Configuration* found = parameters.find(key);
  if (found == nullptr) {
    throw ConfigError(parameters.location(), "<parameters> has no '" + key + "', which " + user + " needs");
  }
  return *found;
}

}  // namespace swarmanoid

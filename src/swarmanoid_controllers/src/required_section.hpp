/// Elements that the parameters of a controller must have.
#pragma once

#include <string>

#include "swarmanoid_interface/configuration.hpp"

namespace swarmanoid {

/// @param key the element's tag @param user of the element, for the message: "the network"
/// @throws ConfigError if it is missing
inline const Configuration& requiredSection(const Configuration& parameters, const std::string& key,
                                            const std::string& user) {
  const Configuration* found = parameters.find(key);
  if (found == nullptr) {
    throw ConfigError(parameters.location(), "<parameters> has no '" + key + "', which " + user + " needs");
  }
  return *found;
}

}  // namespace swarmanoid

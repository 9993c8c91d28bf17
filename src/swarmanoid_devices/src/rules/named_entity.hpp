/// Lookup of the entity that a rule's parameter names.
#pragma once

#include <string>
#include <vector>

#include "swarmanoid_interface/configuration.hpp"
#include "swarmanoid_space/space.hpp"

namespace swarmanoid::devices {

/// @return its row @throws ConfigError with the parameter's name if there is none
inline Row requireEntity(const Space& space, const std::string& parameter, const std::string& id,
                         const SourceLocation& location) {
  const Row found = space.entities.find(id);
  if (found == kNoRow) {
    std::vector<std::string> known;
    for (const Row row : space.entities.order) {
      known.push_back(space.entities.name[row]);
    }
    throw ConfigError(location,
                      parameter + ": found '" + id + "', allowed: the id of an entity" + didYouMean(id, known));
  }
  return found;
}

}  // namespace swarmanoid::devices

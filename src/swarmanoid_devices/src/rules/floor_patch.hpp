/// Lookup of the floor patch that a rule's parameter names.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "swarmanoid_interface/configuration.hpp"
#include "swarmanoid_space/space.hpp"

namespace swarmanoid::devices {

/// @return its index among the floor's patches @throws ConfigError with the parameter's name if there is none
inline std::size_t requireFloorPatch(const Space& space, const std::string& parameter, const std::string& id,
                                     const SourceLocation& location) {
  const std::vector<FloorPatch>& patches = space.floor.patches;
  const auto found =
      std::find_if(patches.begin(), patches.end(), [&](const FloorPatch& patch) { return patch.id == id; });
  if (found == patches.end()) {
    std::vector<std::string> known;
    for (const FloorPatch& patch : patches) {
      known.push_back(patch.id);
    }
    throw ConfigError(location, parameter + ": found '" + id + "', allowed: the id of a floor patch (" +
                                    joinNames(known) + ")" + didYouMean(id, known));
  }
  return static_cast<std::size_t>(found - patches.begin());
}

}  // namespace swarmanoid::devices

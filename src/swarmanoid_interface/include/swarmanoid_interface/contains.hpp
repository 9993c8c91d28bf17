/// Searches a list of names. unknownName (configuration.hpp) makes the error message for a name that is not in a list.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

namespace swarmanoid {

/// Returns whether `names` contains `name`, by linear search.
inline bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace swarmanoid

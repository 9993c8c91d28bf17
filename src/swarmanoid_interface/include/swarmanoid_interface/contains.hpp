/// Whether a name is among others. unknownName (configuration.hpp) words the refusal of one that is not.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

namespace swarmanoid {

/// Takes time proportional to the number of names.
inline bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace swarmanoid

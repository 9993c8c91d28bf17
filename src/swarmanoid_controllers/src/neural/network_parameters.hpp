/// Parameters of the neural controllers other than inputs and outputs.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "swarmanoid_interface/configuration.hpp"

namespace swarmanoid::neural {

/// Reads a list of exactly `count` numbers. @param shape their purpose, for messages
/// @throws ConfigError with the count if it differs
inline std::vector<double> numbersOf(const Configuration& parameters, const std::string& key, std::size_t count,
                                     const std::string& shape, Range range = {}) {
  const std::string needed = std::to_string(count) + " numbers separated by commas (" + shape + ")";
  const Configuration* found = parameters.find(key);
  if (found == nullptr) {
    throw ConfigError(parameters.location(), "<parameters> has no '" + key + "', which the network needs: " + needed);
  }
  const std::string& text = found->text();
  const auto commas = static_cast<std::size_t>(std::count(text.begin(), text.end(), ','));
  const std::size_t there = text.empty() ? 0 : commas + 1;
  if (there != count) {
    throw ConfigError(found->location(), key + ": found " + std::to_string(there) + " numbers, allowed: " + needed);
  }
  return count == 0 ? std::vector<double>() : parseNumbers(text, count, key, found->location(), range);
}

}  // namespace swarmanoid::neural

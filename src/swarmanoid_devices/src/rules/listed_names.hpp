/// Parsing of parameters that list names.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

namespace swarmanoid::devices {

/// @param text names separated by commas
/// @return the names without surrounding white space; empty for an empty text
inline std::vector<std::string> listedNames(const std::string& text) {
  std::vector<std::string> names;
  for (std::size_t start = 0; !text.empty() && start <= text.size();) {
    const std::size_t end = std::min(text.find(',', start), text.size());
    const std::string part = text.substr(start, end - start);
    const std::size_t first = part.find_first_not_of(" \t\n");
    const std::size_t last = part.find_last_not_of(" \t\n");
    names.push_back(first == std::string::npos ? "" : part.substr(first, last - first + 1));
    start = end + 1;
  }
  return names;
}

}  // namespace swarmanoid::devices

#include "swarmanoid_experiment_files/override_text.hpp"

#include <sstream>

namespace swarmanoid {

Override parseOverride(const std::string& text, const std::string& option) {
  const auto equals = text.find('=');
  if (equals == std::string::npos || equals == 0) {
    throw ConfigError({option, 0}, "found '" + text + "', allowed: path=value");
  }
  return {text.substr(0, equals), text.substr(equals + 1)};
}

std::vector<Override> parseOverrides(const std::string& text, const std::string& option) {
  std::vector<Override> overrides;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    if (overrides.empty() || word.find('=') != std::string::npos) {
      overrides.push_back(parseOverride(word, option));
    } else {
      overrides.back().value += " " + word;
    }
  }
  return overrides;
}

}  // namespace swarmanoid

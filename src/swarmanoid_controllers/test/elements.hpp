/// Builds configuration elements for tests.
#pragma once

#include <string>
#include <vector>

#include "swarmanoid_interface/configuration.hpp"

namespace swarmanoid::test {

/// An element with children.
inline Configuration element(const std::string& name, const std::vector<Configuration>& children) {
  Configuration result(name, "", {"file.xml", 7});
  for (const Configuration& child : children) {
    result.add(child);
  }
  return result;
}

/// An element or attribute with text.
inline Configuration value(const std::string& name, const std::string& text = "") {
  return {name, text, {"file.xml", 8}};
}

/// Message of the ConfigError that a call throws; "" if it throws none.
template <class Call>
std::string refusalOf(Call call) {
  try {
    call();
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "";
}

}  // namespace swarmanoid::test

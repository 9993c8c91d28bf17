/// Checks that colours by which a controller recognizes objects, or which its robot shows, are distinct.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "swarmanoid_interface/color.hpp"
#include "swarmanoid_interface/configuration.hpp"

namespace swarmanoid {

struct NamedColor {
  std::string name;  ///< name of the parameter; a description for a colour without a parameter
  Color color;
};

/// @throws ConfigError if two colours are equal, at the one that the parameters set
inline void refuseEqualColors(const Configuration& parameters, const std::vector<NamedColor>& colors) {
  for (std::size_t i = 0; i < colors.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (colors[i].color == colors[j].color) {
        const bool is_later_given = parameters.has(colors[i].name);
        const NamedColor& found = colors[is_later_given ? i : j];
        const NamedColor& other = colors[is_later_given ? j : i];
        const Configuration* element = parameters.find(found.name);
        throw ConfigError(element == nullptr ? parameters.location() : element->location(),
                          found.name + ": found '" + toString(found.color) + "', which is " + other.name +
                              " too, allowed: a colour of its own");
      }
    }
  }
}

}  // namespace swarmanoid

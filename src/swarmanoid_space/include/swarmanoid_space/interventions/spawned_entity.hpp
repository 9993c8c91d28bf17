/// An entity described by names and values instead of by a file, as in messages and Python calls.
#pragma once

#include <optional>
#include <string>

#include "swarmanoid_interface/color.hpp"
#include "swarmanoid_space/experiment/experiment.hpp"
#include "swarmanoid_space/intervention.hpp"
#include "swarmanoid_space/state/entities.hpp"

namespace swarmanoid {

struct AskedEntity {
  std::string type;  ///< or an alias of it
  std::string name;
  std::string controller;  ///< id; "": none
  Pose pose;               ///< in W
  NamedValues values;      ///< of the type, written as in the experiment file, each once
  std::optional<Color> color;
};

/// Converts it to a description as from a file, with defaults for missing values. Checks only the colour; the space
/// checks the rest. @throws ConfigError for an invalid colour
EntityDescription describeEntity(const AskedEntity& asked);

}  // namespace swarmanoid

/// An entity that is asked for by names and values instead of by a file: what messages and Python bring.
#pragma once

#include <optional>
#include <string>

#include "swarmanoid_interface/color.hpp"
#include "swarmanoid_space/experiment_file/experiment.hpp"
#include "swarmanoid_space/intervention.hpp"
#include "swarmanoid_space/state/entities.hpp"

namespace swarmanoid {

struct AskedEntity {
  std::string type;  ///< or an alias of it
  std::string name;
  std::string controller;  ///< id; "": none
  Pose pose;               ///< in W
  NamedValues values;      ///< of the type, as they would stand in the experiment file, each once
  std::optional<Color> color;
};

/// As a file would describe it, with defaults for all that is not given. What is wrong with it the space says: only
/// the colour is read here. @throws ConfigError for a colour that is none
EntityDescription describeEntity(const AskedEntity& asked);

}  // namespace swarmanoid

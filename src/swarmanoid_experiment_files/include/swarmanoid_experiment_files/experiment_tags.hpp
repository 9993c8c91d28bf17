/// The built-in tags of experiment files. The reader, the schema and `swarmanoid list` use this one table: tags and
/// attributes outside the table cannot be read, and all entries are listed.
#pragma once

#include <string>
#include <vector>

#include "swarmanoid_interface/registry.hpp"

namespace swarmanoid {

struct ExperimentAttribute {
  Parameter value;  ///< no default: the attribute is required; the default "": it may be omitted
  bool is_id = false;
};

struct ExperimentTag {
  std::string in;       ///< path of the parent: "arena", "arena_physics/handover"; "" is the root
  std::string name;     ///< "*": every tag of a plugin at that place
  std::string heading;  ///< section of `swarmanoid list`: the name of a section, or of a kind of plugin
  std::string summary;
  std::vector<ExperimentAttribute> attributes;
  std::vector<Parameter> values;  ///< child elements that hold one value
};

/// Returns the table. Loading a library may register kinds of errors; later calls include them. Thread-safe; earlier
/// results stay valid.
const std::vector<ExperimentTag>& experimentTags();

}  // namespace swarmanoid

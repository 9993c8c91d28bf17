/// The tags of experiment files that no plugin brings. The reader, the schema and `swarmanoid list` go by this one
/// table: a tag or an attribute that is not in it cannot be read, and what is in it is listed.
#pragma once

#include <string>
#include <vector>

#include "swarmanoid_interface/registry.hpp"

namespace swarmanoid {

struct ExperimentAttribute {
  Parameter value;  ///< no default: the attribute must be there; the default "": it may be left out
  bool is_id = false;
};

struct ExperimentTag {
  std::string in;       ///< the path of what it stands in: "arena", "arena_physics/handover"; "" is the root
  std::string name;     ///< "*": every tag of a plugin that stands there
  std::string heading;  ///< where `swarmanoid list` shows it: the name of a section, or of a kind of plugin
  std::string summary;
  std::vector<ExperimentAttribute> attributes;
  std::vector<Parameter> values;  ///< child elements that hold one value
};

/// A library that is loaded may bring kinds of errors, which are in what is returned from then on. Thread-safe; what
/// was returned stays valid.
const std::vector<ExperimentTag>& experimentTags();

}  // namespace swarmanoid

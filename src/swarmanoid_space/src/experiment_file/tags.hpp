/// What the reader and the schema look up in the table of tags. A path is "arena/distribute"; "*" in it is any plugin.
#pragma once

#include <string>
#include <vector>

#include "parameter_table.hpp"
#include "swarmanoid_space/experiment_file/experiment_tags.hpp"

namespace swarmanoid::experiment {

/// @throws std::logic_error if there is none
const ExperimentTag& tagAt(const std::string& path);
/// That of plugins that a section lists: "rules/*". @param kind controllers, engines, rules or observers
std::string pathOf(PluginKind kind);
/// The names of its attributes.
std::vector<std::string> attributesOf(const std::string& path);
/// The names of its values.
std::vector<std::string> valuesOf(const std::string& path);
/// The names of the tags that may stand in it, plugins left out, in the order of the table.
std::vector<std::string> tagsIn(const std::string& path);

}  // namespace swarmanoid::experiment

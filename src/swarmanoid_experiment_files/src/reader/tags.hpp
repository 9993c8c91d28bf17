/// Look-ups in the table of tags, for the reader and the schema. A path is "arena/distribute"; "*" in it is any plugin.
#pragma once

#include <string>
#include <vector>

#include "parameter_table.hpp"
#include "swarmanoid_experiment_files/experiment_tags.hpp"

namespace swarmanoid::experiment {

/// Returns the tag at a path. @throws std::logic_error if there is none
const ExperimentTag& tagAt(const std::string& path);
/// Path of the plugins that a section lists: "rules/*". @param kind controllers, engines, rules or observers
std::string pathOf(PluginKind kind);
/// Names of the tag's attributes.
std::vector<std::string> attributesOf(const std::string& path);
/// Names of the tag's values.
std::vector<std::string> valuesOf(const std::string& path);
/// Names of the tags that a tag may contain, without plugins, in the order of the table.
std::vector<std::string> tagsIn(const std::string& path);

}  // namespace swarmanoid::experiment

/// Reads the values of an element by a table of parameters. The schema is made from the same tables.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "swarmanoid_experiment_files/xml/xml_element.hpp"
#include "swarmanoid_interface/registry.hpp"
#include "swarmanoid_space/experiment/entity_parameters.hpp"
#include "swarmanoid_space/experiment/experiment.hpp"
#include "swarmanoid_space/models/limits.hpp"

namespace swarmanoid::experiment {

/// Reads and checks each child element that the table contains, and fills in the defaults of absent ones.
/// @param others further allowed child elements; they are not read
/// @throws ConfigError for an unknown, doubled, missing or malformed value
Configuration readParameters(const XmlElement& element, const std::vector<Parameter>& table,
                             const std::vector<std::string>& others = {});

/// Returns the value of an attribute with fixed choices; `fallback` if the attribute is absent and there is a fallback.
/// @throws ConfigError for any other value
std::string readChoice(const XmlElement& element, const char* name, const std::vector<std::string>& choices,
                       const std::optional<std::string>& fallback);

/// `<realism>` of devices. @param usual default value; "": the preset of the enclosing element
Parameter realismParameter(const std::string& usual = "");

// Tables of the sections.
const std::vector<Parameter>& frameworkParameters();
/// Of <floor_patch>; `radius` and `size` exclude each other.
const std::vector<Parameter>& floorPatchParameters();
/// Of <hole>; `radius` and `size` exclude each other.
const std::vector<Parameter>& holeParameters();
/// Of <floor_image>.
const std::vector<Parameter>& floorImageParameters();
/// Of <floor_paint>.
const std::vector<Parameter>& floorPaintParameters();
/// Of <heightfield>.
const std::vector<Parameter>& heightfieldParameters();
/// Of <distribute>, for all areas together; quantity, layout and area are attributes.
const std::vector<Parameter>& distributeParameters();
/// Parameters that <distribute> allows with one area.
std::vector<Parameter> distributeParameters(Distribution::Area area, bool is_around);
/// Names of the areas, in the order of Distribution::Area.
const std::vector<std::string>& areas();
/// Of <inside> and <outside> in <handover>.
const std::vector<Parameter>& boxParameters();

// Allowed values of attributes.
constexpr Range kCommandTimeoutRange{0.001, 3600.0};  // s
constexpr Range kQuantityRange{1.0, static_cast<double>(limits::kMostEntities)};
const std::vector<std::string>& layouts();
const std::vector<std::string>& optimizations();
const std::vector<std::string>& roles();
/// Languages of controllers and rules; the first is the default.
const std::vector<std::string>& codeLanguages();
/// Values of `source`: the possible commanders of a robot.
const std::vector<std::string>& commandSources();
/// Names of the two ends of a grip.
const std::vector<std::string>& gripEnds();

}  // namespace swarmanoid::experiment

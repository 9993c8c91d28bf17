/// Reading the values of an element by a table of parameters, the same tables that the schema is made from.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "swarmanoid_interface/registry.hpp"
#include "swarmanoid_space/experiment_file/experiment.hpp"
#include "swarmanoid_space/models/limits.hpp"
#include "xml_element.hpp"

namespace swarmanoid::experiment {

/// Reads each child element that the table knows, checks it, and fills in defaults for those that are not there.
/// @param others child elements that are allowed too and left alone
/// @throws ConfigError for an unknown, doubled, missing or malformed value
Configuration readParameters(const XmlElement& element, const std::vector<Parameter>& table,
                             const std::vector<std::string>& others = {});

/// Checks one value against its parameter. @throws ConfigError
void checkValue(const Parameter& parameter, const std::string& text, const SourceLocation& location);

/// The choice that an attribute makes; without the attribute the choice is `fallback`, if there is one.
/// @throws ConfigError for what is none of the choices
std::string readChoice(const XmlElement& element, const char* name, const std::vector<std::string>& choices,
                       const std::optional<std::string>& fallback);

/// `<realism>` of devices. @param usual meant where nothing is said: that of the element around it, if it is ""
Parameter realismParameter(const std::string& usual = "");

// The tables of the sections themselves.
const std::vector<Parameter>& frameworkParameters();
/// Where an entity is. In <distribute> it has no position.
std::vector<Parameter> placementParameters(bool is_distributed);
/// Where an entity is put: a position and then an orientation, both of which must be there.
std::vector<Parameter> poseParameters();
/// Of an entity: those of its type, and its placement. In <distribute> it has no position.
std::vector<Parameter> entityParameters(const PluginDescription& type, bool is_distributed);
/// Of <floor_patch>; `radius` and `size` exclude each other.
const std::vector<Parameter>& floorPatchParameters();
/// Of <hole>, likewise.
const std::vector<Parameter>& holeParameters();
/// Of <floor_image>.
const std::vector<Parameter>& floorImageParameters();
/// Of <floor_paint>.
const std::vector<Parameter>& floorPaintParameters();
/// Of <heightfield>.
const std::vector<Parameter>& heightfieldParameters();
/// Of <distribute>, whichever its area is; quantity, layout and area are attributes.
const std::vector<Parameter>& distributeParameters();
/// Those of an area: the others must not be there.
std::vector<Parameter> distributeParameters(Distribution::Area area, bool is_around);
/// The names of areas, in the order of Distribution::Area.
const std::vector<std::string>& areas();
/// Of <inside> and <outside> in <handover>.
const std::vector<Parameter>& boxParameters();

// What attributes may be.
constexpr Range kCommandTimeoutRange{0.001, 3600.0};  // s
constexpr Range kTickRange{0.0, limits::kTicks.maximum};
constexpr Range kQuantityRange{1.0, static_cast<double>(limits::kMostEntities)};
const std::vector<std::string>& layouts();
const std::vector<std::string>& optimizations();
const std::vector<std::string>& roles();
/// What controllers and rules are written in; the first is meant where nothing is said.
const std::vector<std::string>& codeLanguages();
/// Who may command a robot.
const std::vector<std::string>& commandSources();
/// What the ends of a grip are called.
const std::vector<std::string>& gripEnds();

}  // namespace swarmanoid::experiment

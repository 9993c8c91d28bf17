#include "parameter_table.hpp"

#include <algorithm>

#include "swarmanoid_experiment_files/realism.hpp"
#include "swarmanoid_interface/contains.hpp"

namespace swarmanoid::experiment {
namespace {

/// Parameters of a disc or a rectangle on the floor. @param position description of its centre
std::vector<Parameter> areaParameters(const std::string& position) {
  using Type = Parameter::Type;
  return {makeParameter("position", Type::kVector3, "m", std::nullopt, limits::kCoordinate, position),
          makeParameter("radius", Type::kNumber, "m", "0", limits::kPatch, "Of a disc; 0: a rectangle of <size>."),
          makeParameter("size", Type::kVector2, "m", "0, 0", limits::kPatch, "Of a rectangle along x and y.")};
}

}  // namespace

std::string readChoice(const XmlElement& element, const char* name, const std::vector<std::string>& choices,
                       const std::optional<std::string>& fallback) {
  Parameter choice = makeParameter(name, Parameter::Type::kChoice, "", std::nullopt, {}, "");
  choice.choices = choices;
  const auto given = element.attribute(name);
  std::string text = fallback ? given.value_or(*fallback) : element.requireAttribute(name);
  checkValue(choice, text, element.attributeLocation(name));
  return text;
}

Configuration readParameters(const XmlElement& element, const std::vector<Parameter>& table,
                             const std::vector<std::string>& others) {
  std::vector<std::string> names;
  for (const Parameter& parameter : table) {
    names.push_back(parameter.name);
  }
  std::vector<std::string> allowed = names;
  allowed.insert(allowed.end(), others.begin(), others.end());
  element.allowChildren(allowed);

  Configuration result(element.name(), "", element.location());
  for (const Parameter& parameter : table) {
    if (const auto child = element.child(parameter.name.c_str())) {
      child->allowAttributes({});
      checkValue(parameter, child->text(), child->location());
      result.add(Configuration(parameter.name, child->text(), child->location()));
    } else if (parameter.value) {
      result.add(Configuration(parameter.name, *parameter.value, element.location()));
    } else {
      element.refuse("<" + element.name() + "> needs <" + parameter.name + ">");
    }
  }
  return result;
}

Parameter realismParameter(const std::string& usual) {
  Parameter parameter =
      makeParameter("realism", Parameter::Type::kChoice, "", usual, {},
                    usual.empty() ? "Preset for values that the file does not set; else that of the element around it."
                                  : "Preset of all devices: ideal, or as on a robot.");
  parameter.choices = realismNames();
  return parameter;
}

const std::vector<Parameter>& frameworkParameters() {
  using Type = Parameter::Type;
  static const std::vector<Parameter> table{
      makeParameter("clocktick", Type::kNumber, "ms", std::nullopt, {0.001, 1e6}, "Duration of a tick."),
      makeParameter("maxclock", Type::kInteger, "ticks", std::nullopt, limits::kTicks,
                    "Ticks after which the run is finished."),
      makeParameter("controller_path", Type::kText, "", "", {},
                    "Folders, separated by colons, that libraries are looked for in first."),
      makeParameter("random_seed", Type::kInteger, "", "1", limits::kSeed, "Seed of all random numbers."),
      makeParameter("threads", Type::kInteger, "", "1", limits::kThreads,
                    "Threads that the run may use; results do not depend on it."),
      makeParameter("real_time_factor", Type::kNumber, "", "0", {0.0, 1e6},
                    "Simulated seconds for each real one; 0: as fast as possible. Headless runs ignore it."),
      realismParameter(kIdealRealism)};
  return table;
}

const std::vector<Parameter>& floorPatchParameters() {
  static const std::vector<Parameter> table = [] {
    std::vector<Parameter> parameters = areaParameters("Of the patch's centre.");
    parameters.push_back(
        makeParameter("color", Parameter::Type::kColor, "", "gray", {}, "As cameras and ground sensors see it."));
    return parameters;
  }();
  return table;
}

const std::vector<Parameter>& holeParameters() {
  static const std::vector<Parameter> table = areaParameters("Of the hole's centre; its height is ignored.");
  return table;
}

const std::vector<Parameter>& floorImageParameters() {
  using Type = Parameter::Type;
  static const std::vector<Parameter> table{
      makeParameter("file", Type::kText, "", std::nullopt, {},
                    "A PNG image; its folder is relative to the experiment file's."),
      makeParameter("position", Type::kVector3, "m", std::nullopt, limits::kCoordinate, "Of its middle."),
      makeParameter("size", Type::kVector2, "m", std::nullopt, limits::kLength, "Along x and y.")};
  return table;
}

const std::vector<Parameter>& floorPaintParameters() {
  using Type = Parameter::Type;
  static const std::vector<Parameter> table{
      makeParameter("cell", Type::kNumber, "m", "0.02", limits::kLength, "The side of the squares that are painted."),
      makeParameter("half_life", Type::kNumber, "s", "0", limits::kHalfLife,
                    "After which half of the paint is left; 0: it does not fade.")};
  return table;
}

const std::vector<Parameter>& heightfieldParameters() {
  using Type = Parameter::Type;
  static const std::vector<Parameter> table{
      makeParameter("file", Type::kText, "", std::nullopt, {},
                    "A grey PNG image of 8 or 16 bits; its folder is relative to the experiment file's."),
      makeParameter("position", Type::kVector3, "m", std::nullopt, limits::kCoordinate,
                    "Of its middle, at the height of black."),
      makeParameter("size", Type::kVector2, "m", std::nullopt, limits::kLength, "Along x and y."),
      makeParameter("height", Type::kNumber, "m", std::nullopt, limits::kTerrainHeight, "Of white over black.")};
  return table;
}

std::vector<Parameter> distributeParameters(Distribution::Area area, bool is_around) {
  using Type = Parameter::Type;
  using Area = Distribution::Area;
  const auto place = [](const char* name, const char* description) {
    return makeParameter(name, Type::kVector3, "m", std::nullopt, limits::kCoordinate, description);
  };
  const auto length = [](const char* name, const Range& range, const char* description) {
    return makeParameter(name, Type::kNumber, "m", std::nullopt, range, description);
  };
  std::vector<Parameter> table;
  if (area == Area::kBox) {
    table = {place("minimum", "Of a box: smallest coordinates of the origins."),
             place("maximum", "Of a box: largest coordinates of the origins.")};
  } else if (area == Area::kLine) {
    table = {place("from", "Of a line: its one end."), place("to", "Of a line: its other end.")};
  } else {
    table = {place("center", "Of a disc or a ring: its middle; around an entity 0, 0, 0 unless it is given."),
             length("radius", limits::kLength, "Of a disc or a ring: of its outer border.")};
    if (is_around) {
      table[0].value = "0, 0, 0";
    }
  }
  if (area == Area::kRing) {
    table.push_back(length("inner_radius", limits::kPatch, "Of a ring: of its inner border; at most radius."));
  }
  const std::vector<Parameter> of_all{
      makeParameter("around", Type::kText, "", "", {},
                    "An entity that stands before these: x and y count from its origin."),
      makeParameter("random_heading", Type::kBoolean, "", "true", {},
                    "Headings uniform about z; otherwise all as <orientation> says."),
      makeParameter("max_trials", Type::kInteger, "", "100", {1.0, 1e6},
                    "Random places tried for each entity before it is an error.")};
  table.insert(table.end(), of_all.begin(), of_all.end());
  return table;
}

const std::vector<Parameter>& distributeParameters() {
  static const std::vector<Parameter> table = [] {
    using Area = Distribution::Area;
    std::vector<Parameter> all = distributeParameters(Area::kBox, false);
    for (const Area area : {Area::kRing, Area::kLine}) {  // a ring has all parameters of a disc
      for (const Parameter& parameter : distributeParameters(area, false)) {
        if (std::none_of(all.begin(), all.end(), [&](const auto& known) { return known.name == parameter.name; })) {
          all.push_back(parameter);
        }
      }
    }
    for (Parameter& parameter : all) {
      parameter.value = parameter.value.value_or("");  // not required by every area
    }
    return all;
  }();
  return table;
}

const std::vector<std::string>& areas() {
  static const std::vector<std::string> names{"box", "disc", "ring", "line"};
  return names;
}

const std::vector<Parameter>& boxParameters() {
  using Type = Parameter::Type;
  static const std::vector<Parameter> table{
      makeParameter("minimum", Type::kVector3, "m", std::nullopt, limits::kCoordinate,
                    "Smallest coordinates of the entity's origin."),
      makeParameter("maximum", Type::kVector3, "m", std::nullopt, limits::kCoordinate,
                    "Largest coordinates of the entity's origin.")};
  return table;
}

const std::vector<std::string>& layouts() {
  static const std::vector<std::string> names{"uniform", "grid"};
  return names;
}

const std::vector<std::string>& optimizations() {
  static const std::vector<std::string> names{"2D", "3D"};
  return names;
}

const std::vector<std::string>& roles() {
  static const std::vector<std::string> names{"move", "mirror"};
  return names;
}

const std::vector<std::string>& codeLanguages() {
  static const std::vector<std::string> choices{"cpp", "python"};
  return choices;
}

const std::vector<std::string>& commandSources() {
  static const std::vector<std::string> names{"controller", "remote", "topics", "none"};
  return names;
}

const std::vector<std::string>& gripEnds() {
  static const std::vector<std::string> names{"gripper", "gripped"};
  return names;
}

}  // namespace swarmanoid::experiment

#include "intervention_forms.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "../reader/parameter_table.hpp"
#include "fault_form.hpp"
#include "spawn_form.hpp"
#include "swarmanoid_interface/orientation.hpp"

namespace swarmanoid {
namespace {

using experiment::XmlElement;

/// Attributes, reader and writer of one kind.
template <class What>
struct InterventionForm;

template <>
struct InterventionForm<SpawnEntity> {
  static std::vector<std::string> attributes() { return {"engines", "color"}; }

  static SpawnEntity read(const XmlElement& element, const Experiment& experiment) {
    return readSpawn(element, experiment);
  }

  static void write(const SpawnEntity& what, ElementText& text) { writeSpawn(what, text); }
};

template <>
struct InterventionForm<DeleteEntity> {
  static std::vector<std::string> attributes() { return {"entity"}; }

  static DeleteEntity read(const XmlElement& element, const Experiment& /*experiment*/) {
    element.allowChildren({});
    return {element.requireAttribute("entity")};
  }

  static void write(const DeleteEntity& what, ElementText& text) { text.attribute("entity", what.entity); }
};

template <>
struct InterventionForm<MoveEntity> {
  static std::vector<std::string> attributes() { return {"entity"}; }

  static MoveEntity read(const XmlElement& element, const Experiment& /*experiment*/) {
    MoveEntity result{element.requireAttribute("entity"), {}};
    std::vector<Parameter> table = experiment::poseParameters();
    const auto quaternion = element.child("quaternion");
    if (quaternion) {
      if (const auto orientation = element.child("orientation")) {
        orientation->refuse("found <orientation> beside <quaternion> in <move>, allowed: one of them");
      }
      table.pop_back();
    }
    const Configuration values = experiment::readParameters(element, table, {"quaternion"});
    result.pose.position = values.vector3("position");
    result.pose.orientation = quaternion ? readQuaternion(*quaternion)
                                         : orientationFromAngles(values.vector3("orientation") * (M_PI / 180.0));
    return result;
  }

  static void write(const MoveEntity& what, ElementText& text) {
    text.attribute("entity", what.entity);
    text.value("position", numbersText(std::array<double, 3>{what.pose.position.x(), what.pose.position.y(),
                                                             what.pose.position.z()}));
    const Eigen::Quaterniond& q = what.pose.orientation;
    text.value("quaternion", numbersText(std::array<double, 4>{q.w(), q.x(), q.y(), q.z()}));
  }

 private:
  static Eigen::Quaterniond readQuaternion(const XmlElement& element) {
    element.allowAttributes({});
    const std::vector<double> numbers = parseNumbers(element.text(), 4, "quaternion", element.location());
    return {numbers[0], numbers[1], numbers[2], numbers[3]};
  }
};

template <>
struct InterventionForm<HandOverEntity> {
  static std::vector<std::string> attributes() { return {"entity", "engine"}; }

  static HandOverEntity read(const XmlElement& element, const Experiment& experiment) {
    element.allowChildren({});
    return {element.requireAttribute("entity"),
            requireEngineId(element, "engine", element.requireAttribute("engine"), experiment)};
  }

  static void write(const HandOverEntity& what, ElementText& text) {
    text.attribute("entity", what.entity);
    text.attribute("engine", what.engine);
  }
};

template <>
struct InterventionForm<SetEngineParameters> {
  static std::vector<std::string> attributes() { return {"engine"}; }

  static SetEngineParameters read(const XmlElement& element, const Experiment& experiment) {
    SetEngineParameters result{requireEngineId(element, "engine", element.requireAttribute("engine"), experiment), {}};
    element.refuseText();
    for (const XmlElement& value : element.children()) {
      element.child(value.name().c_str());  // throws for a second one
      value.allowAttributes({});
      result.values.emplace_back(value.name(), value.text());
    }
    if (result.values.empty()) {
      element.refuse("found no value in <engine_parameters>, allowed: one or more");
    }
    return result;
  }

  /// Writes the values; only the last one of a parameter that is set twice.
  static void write(const SetEngineParameters& what, ElementText& text) {
    text.attribute("engine", what.engine);
    for (auto value = what.values.begin(); value != what.values.end(); ++value) {
      const auto is_same = [&](const auto& later) { return later.first == value->first; };
      if (std::none_of(value + 1, what.values.end(), is_same)) {
        text.value(value->first, value->second);
      }
    }
  }
};

template <>
struct InterventionForm<SetCommandSource> {
  static std::vector<std::string> attributes() { return {"robot", "source"}; }

  static SetCommandSource read(const XmlElement& element, const Experiment& /*experiment*/) {
    element.allowChildren({});
    const std::string robot = element.requireAttribute("robot");
    const std::string source = element.requireAttribute("source");
    const auto parsed = parseCommandSource(source);
    if (!parsed) {
      throw ConfigError(element.attributeLocation("source"),
                        "source: " + unknownName("the value", source, experiment::commandSources()));
    }
    return {robot, *parsed};
  }

  static void write(const SetCommandSource& what, ElementText& text) {
    text.attribute("robot", what.robot);
    text.attribute("source", toString(what.source));
  }
};

template <>
struct InterventionForm<SetProperty> {
  static std::vector<std::string> attributes() { return {"entity", "name", "value"}; }

  static SetProperty read(const XmlElement& element, const Experiment& /*experiment*/) {
    element.allowChildren({});
    return {element.requireAttribute("entity"), element.requireAttribute("name"), element.requireAttribute("value")};
  }

  static void write(const SetProperty& what, ElementText& text) {
    text.attribute("entity", what.entity);
    text.attribute("name", what.property);
    text.attribute("value", what.value);
  }
};

template <>
struct InterventionForm<PaintFloor> {
  static std::vector<std::string> attributes() { return {}; }

  static PaintFloor read(const XmlElement& element, const Experiment& /*experiment*/) {
    element.allowChildren({"disc"});
    PaintFloor result;
    for (const XmlElement& disc : element.children()) {
      result.discs.push_back(readDisc(disc));
    }
    if (result.discs.empty()) {
      element.refuse("found no <disc> in <paint>, allowed: one or more");
    }
    return result;
  }

  static void write(const PaintFloor& what, ElementText& text) {
    for (const PaintDisc& disc : what.discs) {
      text.begin("disc");
      text.attribute("position", numbersText(std::array<double, 2>{disc.position.x(), disc.position.y()}));
      text.attribute("radius", numberText(disc.radius));
      text.attribute("color", toString(disc.color));
      text.attribute("strength", numberText(disc.strength));
      text.end();
    }
  }

 private:
  static PaintDisc readDisc(const XmlElement& element) {
    element.allowAttributes({"position", "radius", "color", "strength"});
    element.allowChildren({});
    const auto number = [&](const char* name, const std::string& text, Range range) {
      return parseNumber(text, name, element.attributeLocation(name), range);
    };
    const std::vector<double> position =
        parseNumbers(element.requireAttribute("position"), 2, "position", element.attributeLocation("position"));
    PaintDisc disc;
    disc.position = {position[0], position[1]};
    disc.radius = number("radius", element.requireAttribute("radius"), PaintFloor::kRadius);
    disc.color = parseColorOrThrow(element.requireAttribute("color"), "color", element.attributeLocation("color"));
    disc.strength = number("strength", element.attribute("strength").value_or("1"), PaintFloor::kStrength);
    return disc;
  }
};

template <>
struct InterventionForm<SetFault> {
  static std::vector<std::string> attributes() { return {"robot", "device"}; }

  static SetFault read(const XmlElement& element, const Experiment& experiment) {
    return readFault(element, experiment);
  }

  static void write(const SetFault& what, ElementText& text) { writeFault(what, text); }
};

template <class What>
InterventionGrammar grammarOf() {
  using Form = InterventionForm<What>;
  return {What::kKind, Form::attributes(),
          [](const XmlElement& element, const Experiment& experiment) -> Intervention {
            return Form::read(element, experiment);
          },
          [](const Intervention& intervention, ElementText& text) { Form::write(std::get<What>(intervention), text); }};
}

template <std::size_t... Alternative>
std::array<InterventionGrammar, sizeof...(Alternative)> grammarsOf(std::index_sequence<Alternative...> /*all*/) {
  return {grammarOf<std::variant_alternative_t<Alternative, Intervention>>()...};
}

}  // namespace

const std::array<InterventionGrammar, std::variant_size_v<Intervention>>& interventionGrammars() {
  static const auto grammars = grammarsOf(std::make_index_sequence<std::variant_size_v<Intervention>>());
  return grammars;
}

}  // namespace swarmanoid

// <handover> in <arena_physics>: the condition under which an entity changes the engine that moves it.
#include <algorithm>

#include "reader.hpp"
#include "swarmanoid_space/experiment/entity_parameters.hpp"

namespace swarmanoid::experiment {
namespace {

using Condition = HandoverDescription::Condition;
using End = HandoverDescription::End;

constexpr const char* kRule = "arena_physics/handover";

void readBox(const XmlElement& element, HandoverDescription& rule) {
  const Configuration values = readParameters(element, boxParameters());
  rule.minimum = values.vector3("minimum");
  rule.maximum = values.vector3("maximum");
  if (!((rule.maximum - rule.minimum).minCoeff() >= 0.0)) {
    element.child("maximum")->refuse("maximum: found '" + values.text("maximum") +
                                     "', allowed: nothing below minimum, '" + values.text("minimum") + "'");
  }
}

void readEnd(const XmlElement& element, HandoverDescription& rule) {
  element.allowChildren({});
  if (const auto given = element.attribute("as")) {
    Parameter choice = makeParameter("as", Parameter::Type::kChoice, "", std::nullopt, {}, "");
    choice.choices = gripEnds();
    checkValue(choice, *given, element.attributeLocation("as"));
    rule.end = *given == "gripper" ? End::kGripper : End::kGripped;
  }
}

void readDebug(const XmlElement& element, HandoverDescription& rule) {
  rule.key = element.requireAttribute("key");
  rule.value = element.text();
  if (rule.value.empty()) {
    element.refuse("<debug> needs a text: the value to wait for");
  }
}

void readCondition(const XmlElement& element, HandoverDescription& rule) {
  const std::vector<std::string> names = tagsIn(kRule);
  rule.condition = static_cast<Condition>(std::find(names.begin(), names.end(), element.name()) - names.begin());
  element.allowAttributes(attributesOf(std::string(kRule) + "/" + element.name()));
  switch (rule.condition) {
    case Condition::kInside:
    case Condition::kOutside:
      return readBox(element, rule);
    case Condition::kAttached:
    case Condition::kReleased:
      return readEnd(element, rule);
    case Condition::kDebug:
      return readDebug(element, rule);
  }
}

std::string requireName(const XmlElement& element, const char* attribute, const std::string& what,
                        const KnownNames& known) {
  std::string name = element.requireAttribute(attribute);
  if (!known.has(name)) {
    throw ConfigError(element.attributeLocation(attribute), unknownName(what, name, known.all));
  }
  return name;
}

}  // namespace

void readHandover(const XmlElement& element, const KnownNames& entities, const KnownNames& engines, Reader& reader) {
  element.allowAttributes(attributesOf(kRule));
  element.allowChildren(tagsIn(kRule));
  HandoverDescription rule;
  rule.location = element.location();
  if (element.attribute("id")) {
    rule.id = element.requireAttribute("id");
    reader.takeId("handover", rule.id, element);
  }
  rule.entity = requireName(element, "entity", "the entity", entities);
  rule.engine = requireName(element, "to", "the engine", engines);
  const std::vector<XmlElement> found = element.children();
  if (found.size() != 1) {
    element.refuse("found " + std::to_string(found.size()) + " conditions in <handover>, allowed: one of " +
                   joinNames(tagsIn(kRule)));
  }
  readCondition(found[0], rule);
  reader.experiment.handovers.push_back(std::move(rule));
}

}  // namespace swarmanoid::experiment

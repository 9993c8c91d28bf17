#include "swarmanoid_experiment_files/interventions/intervention_file.hpp"
#include "swarmanoid_experiment_files/read_experiment.hpp"

#include <algorithm>

#include "../reader/reader.hpp"
#include "intervention_forms.hpp"

namespace swarmanoid {
namespace {

using experiment::XmlElement;

constexpr const char* kInterventionsTag = "interventions";

TakenIntervention readTaken(const XmlElement& element, const InterventionGrammar& grammar,
                            const Experiment& experiment) {
  std::vector<std::string> attributes{"tick", "by", "after_rules"};
  attributes.insert(attributes.end(), grammar.attributes.begin(), grammar.attributes.end());
  element.allowAttributes(attributes);
  TakenIntervention taken;
  taken.what = grammar.read(element, experiment);
  taken.tick = static_cast<std::uint64_t>(
      parseInteger(element.requireAttribute("tick"), "tick", element.attributeLocation("tick"), limits::kTick));
  taken.asked_by = element.attribute("by").value_or("");
  taken.after_rules = parseBoolean(element.attribute("after_rules").value_or("false"), "after_rules",
                                   element.attributeLocation("after_rules"));
  return taken;
}

/// Refuses interventions out of order, because they are carried out in the order of the file.
void refuseDisorder(const XmlElement& element, const TakenIntervention& before, const TakenIntervention& taken) {
  if (taken.tick < before.tick) {
    throw ConfigError(element.attributeLocation("tick"), "tick: found '" + std::to_string(taken.tick) +
                                                             "' below a tick " + std::to_string(before.tick) +
                                                             ", allowed: " + std::to_string(before.tick) + " or later");
  }
  if (taken.tick == before.tick && before.after_rules && !taken.after_rules) {
    throw ConfigError(element.attributeLocation("after_rules"),
                      "after_rules: found 'false' below one of the same tick with 'true', allowed: true");
  }
}

std::vector<std::string> interventionTags() {
  std::vector<std::string> tags;
  for (const InterventionGrammar& grammar : interventionGrammars()) {
    tags.emplace_back(grammar.tag);
  }
  return tags;
}

std::string readSeed(const XmlElement& root) {
  const auto seed = root.attribute("seed");
  if (seed && (seed->empty() || seed->find_first_not_of("0123456789") != std::string::npos)) {
    throw ConfigError(root.attributeLocation("seed"), "seed: found '" + *seed + "', allowed: a whole number from 0");
  }
  return seed.value_or("");
}

/// Returns whether the text lacks only the end tag, which a killed run does not write.
bool isOnlyTheEndMissing(const std::string& text) {
  try {
    parseXml(text + interventionsEnd(), "", XmlNamespaces::kRefused);
    return true;
  } catch (const ConfigError&) {
    return false;
  }
}

XmlDocument parseDocument(const std::string& text, const std::string& name) {
  try {
    return parseXml(text, name, XmlNamespaces::kRefused);
  } catch (const ConfigError&) {
    if (isOnlyTheEndMissing(text)) {
      throw ConfigError({name, 0},
                        "found no </interventions> at the end, as a run that was killed leaves it, allowed: a file "
                        "that ends with it");
    }
    throw;
  }
}

}  // namespace

InterventionFile parseInterventions(const std::string& text, const std::string& name, const Experiment& experiment) {
  if (text.empty()) {
    throw ConfigError({name, 0}, "found an empty file, allowed: an <interventions> element");
  }
  const XmlDocument document = parseDocument(text, name);
  const XmlElement root(xmlDocGetRootElement(document.get()), &name);
  if (root.name() != kInterventionsTag) {
    root.refuse("found the root element <" + root.name() + ">, allowed: <" + kInterventionsTag + ">");
  }
  root.allowAttributes({"experiment", "seed"});
  root.allowChildren(interventionTags());
  InterventionFile result;
  result.file = name;
  result.experiment = root.attribute("experiment").value_or("");
  result.seed = readSeed(root);
  for (const XmlElement& element : root.children()) {
    for (const InterventionGrammar& grammar : interventionGrammars()) {
      if (element.name() == grammar.tag) {
        TakenIntervention taken = readTaken(element, grammar, experiment);
        if (!result.interventions.empty()) {
          refuseDisorder(element, result.interventions.back().taken, taken);
        }
        result.interventions.push_back({std::move(taken), element.location()});
      }
    }
  }
  return result;
}

InterventionFile readInterventions(const std::string& file, const Experiment& experiment) {
  return readInterventions(file, file, experiment);
}

InterventionFile readInterventions(const std::string& file, const std::string& name, const Experiment& experiment) {
  return parseInterventions(experiment::textOf(file), name, experiment);
}

bool hasRule(const Experiment& experiment, const std::string& asked_by) {
  return std::any_of(experiment.rules.begin(), experiment.rules.end(),
                     [&](const RuleDescription& rule) { return asked_by.rfind("rule '" + rule.id + "'", 0) == 0; });
}

std::string toXml(const TakenIntervention& taken, int depth) {
  const InterventionGrammar& grammar = interventionGrammars()[taken.what.index()];
  ElementText text(depth);
  text.begin(grammar.tag);
  text.attribute("tick", std::to_string(taken.tick));
  if (taken.after_rules) {
    text.attribute("after_rules", "true");
  }
  if (!taken.asked_by.empty()) {
    text.attribute("by", taken.asked_by);
  }
  grammar.write(taken.what, text);
  text.end();
  return text.text();
}

std::string interventionsBegin(const std::string& experiment, std::uint64_t seed) {
  return std::string("<") + kInterventionsTag + " experiment=\"" + xmlEscaped(experiment) + "\" seed=\"" +
         std::to_string(seed) + "\">\n";
}

std::string interventionsEnd() { return std::string("</") + kInterventionsTag + ">\n"; }

}  // namespace swarmanoid

// The rules of a world: those of the file and those that the caller supplies.
#include <algorithm>

#include "build.hpp"
#include "configure.hpp"
#include "scripts.hpp"

namespace swarmanoid {
namespace {

using SuppliedRules = std::vector<std::pair<std::string, std::shared_ptr<Rule>>>;

SuppliedRules::iterator findRule(SuppliedRules& rules, const std::string& id) {
  return std::find_if(rules.begin(), rules.end(), [&](const auto& rule) { return rule.first == id; });
}

/// @param part see UserCode
RuleInstance configured(const std::shared_ptr<Rule>& plugin, const std::string& part, const std::string& id,
                        const Configuration& parameters, const SourceLocation& location) {
  RuleInstance rule{{plugin, part}};
  rule->setId(id);
  configure(rule, location, parameters);
  return rule;
}

RuleInstance ruleOfFile(World& world, const RuleDescription& description) {
  const std::string part = "rule '" + description.id + "'";
  if (!description.script.empty()) {
    return configured(ruleInScript(world, description), part, description.id, description.parameters,
                      description.location);
  }
  const auto* entry = Registry::instance().find(PluginKind::kRule, description.label);
  return configured(makePlugin<Rule>(*entry), part + " (" + description.label + ")", description.id,
                    description.parameters, description.location);
}

std::vector<std::string> namesOfMetrics(const RuleInstance& rule) {
  std::vector<std::string> names;
  for (const Metric& metric : rule->metrics()) {
    names.push_back(metric.name);
  }
  return names;
}

void collectMetrics(World& world) {
  world.space.metrics.clear();
  for (const RuleInstance& rule : world.assembly.rules) {
    for (const Metric& metric : rule->metrics()) {
      world.space.metrics.push_back(&metric);
    }
  }
}

}  // namespace

void buildRules(World& world) {
  SuppliedRules supplied = world.supplied.rules;
  for (const RuleDescription& description : world.experiment.rules) {
    const auto found = findRule(supplied, description.id);
    if (found == supplied.end()) {
      world.assembly.rules.push_back(ruleOfFile(world, description));
    } else {
      world.assembly.rules.push_back(configured(found->second, "rule '" + description.id + "'", description.id,
                                                description.parameters, description.location));
      supplied.erase(found);
    }
  }
  for (const auto& [id, rule] : supplied) {
    world.assembly.rules.push_back(configured(rule, "rule '" + id + "'", id, {}, {}));
  }
  collectMetrics(world);
}

void renewRulesInScripts(World& world) {
  for (std::size_t i = 0; i < world.experiment.rules.size(); ++i) {  // the assembly begins with these, in this order
    const RuleDescription& description = world.experiment.rules[i];
    const bool is_supplied = findRule(world.supplied.rules, description.id) != world.supplied.rules.end();
    if (!description.script.empty() && !is_supplied) {
      const std::vector<std::string> before = namesOfMetrics(world.assembly.rules[i]);
      world.assembly.rules[i] = ruleOfFile(world, description);
      const std::vector<std::string> now = namesOfMetrics(world.assembly.rules[i]);
      if (now != before) {  // tables have a column for each
        throw ConfigError(description.location, "rule '" + description.id + "': found the metrics " + joinNames(now) +
                                                    ", allowed: those of the run before, " + joinNames(before));
      }
    }
  }
  collectMetrics(world);
}

}  // namespace swarmanoid

// Creates a trigger from each handover rule of the experiment file (thesis chapter 5) and each of its entities.
#include <algorithm>
#include <map>

#include "build.hpp"

namespace swarmanoid {
namespace {

/// Returns the number of entities of each distribution, by id.
std::map<std::string, std::size_t> quantitiesIn(const ArenaDescription& arena) {
  std::map<std::string, std::size_t> quantities;
  for (const EntityDescription& entity : arena.entities) {
    if (entity.distribution) {
      quantities[entity.id] = entity.distribution->quantity;
    }
  }
  return quantities;
}

/// Returns the names of a rule's entities, which may be those of a distribution.
std::vector<std::string> entitiesOf(const HandoverDescription& rule,
                                    const std::map<std::string, std::size_t>& quantities) {
  const auto group = quantities.find(rule.entity);
  if (group == quantities.end()) {
    return {rule.entity};
  }
  std::vector<std::string> names;
  for (std::size_t k = 1; k <= group->second; ++k) {
    names.push_back(rule.entity + "_" + std::to_string(k));
  }
  return names;
}

}  // namespace

void buildTriggers(World& world) {
  const std::map<std::string, std::size_t> quantities = quantitiesIn(world.experiment.arena);
  for (const HandoverDescription& rule : world.experiment.handovers) {
    Engine* engine = world.assembly.findEngine(rule.engine);
    if (engine == nullptr) {
      throw ConfigError(rule.location, "handover: engine '" + rule.engine + "' does not exist");
    }
    for (const std::string& name : entitiesOf(rule, quantities)) {
      const Row row = world.space.entities.find(name);
      if (row == kNoRow) {
        throw ConfigError(rule.location, "handover: there is no entity '" + name + "'");
      }
      const EntityModel& model = *world.space.entities.model[row];
      RobotInstance* instance = world.assembly.findRobot(world.space.entities, row);
      std::string problem = model.is_movable
                                ? unsupportedReasonOf(*engine, model, devicesOf(instance ? instance->group : nullptr),
                                                      world.assembly.memberships[row])
                                : "is fixed, no engine moves it";
      if (problem.empty() && rule.condition == HandoverDescription::Condition::kDebug && instance == nullptr) {
        problem = "has no controller, so it has no debug values";
      }
      if (!problem.empty()) {
        throw ConfigError(rule.location,
                          "handover of " + model.type + " '" + name + "' to engine '" + rule.engine + "': " + problem);
      }
      // a condition that is true from the start has not become true
      world.assembly.triggers.push_back(
          {&rule, engine, row, world.space.entities.number[row], holds(rule, world.space, row)});
    }
  }
  std::stable_sort(world.assembly.triggers.begin(), world.assembly.triggers.end(),
                   [](const HandoverTrigger& a, const HandoverTrigger& b) { return a.number < b.number; });
}

}  // namespace swarmanoid

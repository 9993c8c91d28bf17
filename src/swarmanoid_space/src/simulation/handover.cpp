// Handover between engines (thesis chapter 5): asked for from outside, and the rules of the experiment file.
#include <algorithm>
#include <map>

#include "../assembly/assembly.hpp"
#include "swarmanoid_space/simulation/simulation.hpp"

namespace swarmanoid {
namespace {

/// How many entities distributions make, by id.
std::map<std::string, std::size_t> quantitiesIn(const ArenaDescription& arena) {
  std::map<std::string, std::size_t> quantities;
  for (const EntityDescription& entity : arena.entities) {
    if (entity.distribution) {
      quantities[entity.id] = entity.distribution->quantity;
    }
  }
  return quantities;
}

/// The names that a rule's entity stands for.
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

std::vector<std::string> engineIds(const Space& space) {
  std::vector<std::string> ids;
  for (const Engine* engine : space.engines) {
    ids.push_back(engine->id());
  }
  return ids;
}

}  // namespace

void Simulation::handover(const std::string& name, const std::string& engine_id) {
  const Row row = space_.entities.find(name);
  if (row == kNoRow) {
    std::vector<std::string> known;
    for (const Row other : space_.entities.order) {
      known.push_back(space_.entities.name[other]);
    }
    throw ConfigError({}, "there is no entity '" + name + "'" + didYouMean(name, known));
  }
  Engine* engine = assembly_->findEngine(engine_id);
  if (engine == nullptr) {
    const std::vector<std::string> known = engineIds(space_);
    throw ConfigError(
        {}, "engine '" + engine_id + "' does not exist; there are: " + joinNames(known) + didYouMean(engine_id, known));
  }
  if (space_.mover[row] == engine && space_.entities.model[row]->is_movable) {
    return;
  }
  const std::vector<Row> members = connectedTo(space_.entities, space_.structure, space_.attachments, row);
  refreshMirrors(space_, assembly_->memberships, *engine);
  const std::string problem = handoverProblem(space_, assembly_->robots, assembly_->memberships, members, row, *engine);
  if (!problem.empty()) {
    throw ConfigError({}, space_.entities.model[row]->type + " '" + name + "' cannot be handed over to engine '" +
                              engine_id + "': " + problem);
  }
  pending_events_.push_back({Event::Kind::kIntervention, name, "", "handover to " + engine_id});
  commitHandover(space_, assembly_->robots, assembly_->memberships, members, *engine, pending_events_);
}

void Simulation::buildTriggers() {
  const std::map<std::string, std::size_t> quantities = quantitiesIn(experiment_.arena);
  for (const HandoverDescription& rule : experiment_.handovers) {
    Engine* engine = assembly_->findEngine(rule.engine);
    if (engine == nullptr) {
      throw ConfigError(rule.location, "handover: engine '" + rule.engine + "' does not exist");
    }
    for (const std::string& name : entitiesOf(rule, quantities)) {
      const Row row = space_.entities.find(name);
      if (row == kNoRow) {
        throw ConfigError(rule.location, "handover: there is no entity '" + name + "'");
      }
      const EntityModel& model = *space_.entities.model[row];
      RobotInstance* instance = assembly_->findRobot(space_.entities, row);
      std::string problem = model.is_movable
                                ? unsupportedReasonOf(*engine, model, devicesOf(instance ? instance->group : nullptr),
                                                      assembly_->memberships[row])
                                : "is fixed, no engine moves it";
      if (problem.empty() && rule.condition == HandoverDescription::Condition::kDebug && instance == nullptr) {
        problem = "has no controller, so it has no debug values";
      }
      if (!problem.empty()) {
        throw ConfigError(rule.location,
                          "handover of " + model.type + " '" + name + "' to engine '" + rule.engine + "': " + problem);
      }
      // what is true from the start has not become true
      assembly_->triggers.push_back({&rule, engine, row, space_.entities.number[row], holds(rule, space_, row)});
    }
  }
  std::stable_sort(assembly_->triggers.begin(), assembly_->triggers.end(),
                   [](const HandoverTrigger& a, const HandoverTrigger& b) { return a.number < b.number; });
}

}  // namespace swarmanoid

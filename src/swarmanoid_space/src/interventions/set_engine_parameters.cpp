// Changes parameters of engines during a run.
#include <memory>
#include <utility>

#include "../world/engines.hpp"
#include "carry_out.hpp"
#include "swarmanoid_interface/plain_text.hpp"
#include "swarmanoid_interface/registry.hpp"

namespace swarmanoid {
namespace {

const PluginDescription& descriptionOf(const EngineDescription& engine) {
  return Registry::instance().find(PluginKind::kEngine, engine.label)->description;
}

/// @throws ConfigError naming the live parameters, if that parameter may not change
const Parameter& requireLive(const EngineDescription& engine, const std::string& name) {
  const std::string who = engine.label + " '" + engine.id + "'";
  std::vector<std::string> live;
  const Parameter* found = nullptr;
  for (const Parameter& parameter : descriptionOf(engine).parameters) {
    if (parameter.is_live) {
      live.push_back(parameter.name);
    }
    if (parameter.name == name) {
      found = &parameter;
    }
  }
  const std::string allowed = live.empty() ? "none of its parameters may change while it runs"
                                           : "what may change while it runs: " + joinNames(live);
  if (found == nullptr) {
    throw ConfigError({}, who + " has no parameter '" + name + "'; " + allowed + didYouMean(name, live));
  }
  if (!found->is_live) {
    throw ConfigError({}, who + ": '" + name + "' cannot change while it runs; " + allowed);
  }
  return *found;
}

bool areSame(const Parameter& parameter, const std::string& a, const std::string& b) {
  const bool is_number = parameter.type == Parameter::Type::kNumber || parameter.type == Parameter::Type::kInteger ||
                         parameter.type == Parameter::Type::kAngle;
  return a == b || (is_number && parseNumber(a, parameter.name, {}) == parseNumber(b, parameter.name, {}));
}

Configuration with(const Configuration& old, const std::string& name, const std::string& value) {
  Configuration result(old.name(), old.text(), old.location());
  for (const Configuration& child : old.children()) {
    if (child.name() != name) {
      result.add(child);
    }
  }
  result.add(Configuration(name, value, {}));
  return result;
}

}  // namespace

bool carryOut(World& world, const SetEngineParameters& intervention) {
  const std::string& engine = intervention.engine;
  const std::size_t index = engineIndex(world, engine);
  const EngineDescription& description = world.experiment.engines[index];
  Configuration parameters = parametersOf(world, index);
  std::vector<Event> events;
  for (const auto& [name, value] : intervention.values) {
    const Parameter& parameter = requireLive(description, name);
    checkValue(parameter, value, {});
    const std::string old = parameters.text(name, parameter.value.value_or(""));
    if (!areSame(parameter, old, value)) {
      parameters = with(parameters, name, value);
      events.push_back({Event::Kind::kIntervention, "", "",
                        description.label + " '" + engine + "': " + name + " from " + old + " to " + value});
    }
  }
  if (events.empty()) {
    return false;
  }
  reconfigureEngine(world, index, std::make_shared<const Configuration>(std::move(parameters)));
  world.pending_events.insert(world.pending_events.end(), events.begin(), events.end());
  return true;
}

}  // namespace swarmanoid

// Finds robots that have movement actuators although no engine moves them.
#include <algorithm>
#include <set>

#include "reader.hpp"

namespace swarmanoid::experiment {
namespace {

/// Returns the ids of the entities that an engine moves from the start or takes over later.
std::set<std::string> entitiesInEngines(const Experiment& experiment) {
  std::set<std::string> names;
  for (const MappingDescription& mapping : experiment.mappings) {
    for (const MappingDescription::Member& member : mapping.members) {
      names.insert(member.entity);
    }
  }
  for (const HandoverDescription& handover : experiment.handovers) {
    names.insert(handover.entity);
  }
  return names;
}

/// Returns the actuators of the controller that need an engine: wheels, not LEDs.
std::vector<std::string> movingActuators(const ControllerDescription& controller) {
  std::vector<std::string> types;
  for (const DeviceDescription& device : controller.actuators) {
    const Registry::Entry* entry = Registry::instance().find(PluginKind::kActuator, device.type, device.implementation);
    if (entry != nullptr && !entry->description.mechanisms.empty()) {
      types.push_back(device.type);
    }
  }
  return types;
}

}  // namespace

void warnOfUnmovedRobots(Reader& reader) {
  const Experiment& experiment = reader.experiment;
  const std::set<std::string> moved = entitiesInEngines(experiment);
  for (const EntityDescription& entity : experiment.arena.entities) {
    const auto controller = std::find_if(experiment.controllers.begin(), experiment.controllers.end(),
                                         [&](const auto& one) { return one.id == entity.controller; });
    if (moved.count(entity.id) > 0 || controller == experiment.controllers.end()) {
      continue;
    }
    const std::vector<std::string> actuators = movingActuators(*controller);
    if (!actuators.empty()) {
      reader.warnings.push_back(entity.location.toString() + ": found the " + entity.type + " '" + entity.id +
                                "' in no engine of <arena_physics>, so its " + joinNames(actuators) +
                                " will not move it");
    }
  }
}

}  // namespace swarmanoid::experiment

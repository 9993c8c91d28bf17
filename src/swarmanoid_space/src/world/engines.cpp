#include "engines.hpp"

#include <algorithm>
#include <utility>

#include "swarmanoid_interface/process/user_code.hpp"

namespace swarmanoid {

std::size_t engineIndex(const World& world, const std::string& id) {
  std::vector<std::string> known;
  for (std::size_t i = 0; i < world.assembly.engines.size(); ++i) {
    if (world.assembly.engines[i]->id() == id) {
      return i;
    }
    known.push_back(world.assembly.engines[i]->id());
  }
  throw ConfigError({}, "engine '" + id + "' does not exist; there are: " + joinNames(known) + didYouMean(id, known));
}

const Configuration& parametersOf(const World& world, std::size_t index) {
  const auto& changed = world.engine_parameters[index];
  return changed == nullptr ? world.experiment.engines[index].parameters : *changed;
}

void reconfigureEngine(World& world, std::size_t index, std::shared_ptr<const Configuration> parameters) {
  const Named<Engine>& engine = world.assembly.engines[index];
  callPlugin("reconfigure", engine.part, UserCode::kNoTick, [&] {
    engine->reconfigure(parameters == nullptr ? world.experiment.engines[index].parameters : *parameters);
  });
  world.engine_parameters[index] = std::move(parameters);
}

void restoreEngineParameters(World& world) {
  for (std::size_t i = 0; i < world.engine_parameters.size(); ++i) {
    reconfigureEngine(world, i, nullptr);
  }
}

std::vector<EngineReport> reportEngines(const World& world) {
  std::vector<EngineReport> reports;
  for (std::size_t i = 0; i < world.assembly.engines.size(); ++i) {
    const Engine* engine = world.assembly.engines[i].get();
    EngineReport report;
    report.id = engine->id();
    report.label = world.experiment.engines[i].label;
    report.health = engine->health();
    for (const Row row : world.space.entities.order) {
      if (!world.space.entities.model[row]->is_movable) {
        continue;
      }
      report.moved += world.space.mover[row] == engine ? 1 : 0;
      report.mirrored += static_cast<std::size_t>(
          std::count_if(world.assembly.memberships[row].begin(), world.assembly.memberships[row].end(),
                        [&](const Membership& membership) {
                          return membership.engine == engine && membership.role == Role::kMirror;
                        }));
    }
    reports.push_back(std::move(report));
  }
  return reports;
}

}  // namespace swarmanoid

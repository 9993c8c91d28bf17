// Engines of a running experiment as seen from outside: how they are, and parameters that change live.
#include <algorithm>

#include "../assembly/assembly.hpp"
#include "../experiment_file/parameter_table.hpp"
#include "swarmanoid_space/simulation/simulation.hpp"

namespace swarmanoid {
namespace {

const PluginDescription& descriptionOf(const EngineDescription& engine) {
  return Registry::instance().find(PluginKind::kEngine, engine.label)->description;
}

/// @throws ConfigError naming what may change, if that parameter may not
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

std::size_t Simulation::engineIndex(const std::string& id) const {
  std::vector<std::string> known;
  for (std::size_t i = 0; i < assembly_->engines.size(); ++i) {
    if (assembly_->engines[i]->id() == id) {
      return i;
    }
    known.push_back(assembly_->engines[i]->id());
  }
  throw ConfigError({}, "engine '" + id + "' does not exist; there are: " + joinNames(known) + didYouMean(id, known));
}

const Configuration& Simulation::engineParameters(const std::string& engine) const {
  return engine_parameters_[engineIndex(engine)];
}

void Simulation::setEngineParameters(const std::string& engine, const NamedValues& values) {
  const std::size_t index = engineIndex(engine);
  const EngineDescription& description = experiment_.engines[index];
  Configuration parameters = engine_parameters_[index];
  std::vector<Event> events;
  for (const auto& [name, value] : values) {
    const Parameter& parameter = requireLive(description, name);
    experiment::checkValue(parameter, value, {});
    const std::string old = parameters.text(name, parameter.value.value_or(""));
    if (!areSame(parameter, old, value)) {
      parameters = with(parameters, name, value);
      events.push_back({Event::Kind::kIntervention, "", "",
                        description.label + " '" + engine + "': " + name + " from " + old + " to " + value});
    }
  }
  if (events.empty()) {
    return;
  }
  assembly_->engines[index]->reconfigure(parameters);
  engine_parameters_[index] = std::move(parameters);
  pending_events_.insert(pending_events_.end(), events.begin(), events.end());
}

void Simulation::restoreEngineParameters() {
  for (std::size_t i = 0; i < engine_parameters_.size(); ++i) {
    engine_parameters_[i] = experiment_.engines[i].parameters;
    assembly_->engines[i]->reconfigure(engine_parameters_[i]);
  }
}

std::vector<EngineReport> Simulation::engineReports() const {
  std::vector<EngineReport> reports;
  for (std::size_t i = 0; i < assembly_->engines.size(); ++i) {
    const Engine* engine = assembly_->engines[i].get();
    EngineReport report;
    report.id = engine->id();
    report.label = experiment_.engines[i].label;
    report.health = engine->health();
    for (const Row row : space_.entities.order) {
      if (!space_.entities.model[row]->is_movable) {
        continue;
      }
      report.moved += space_.mover[row] == engine ? 1 : 0;
      report.mirrored += static_cast<std::size_t>(std::count_if(
          assembly_->memberships[row].begin(), assembly_->memberships[row].end(), [&](const Membership& membership) {
            return membership.engine == engine && membership.role == Role::kMirror;
          }));
    }
    reports.push_back(std::move(report));
  }
  return reports;
}

}  // namespace swarmanoid

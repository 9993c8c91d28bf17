#include "machine.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "../required_section.hpp"

namespace swarmanoid {
namespace {

constexpr std::array<std::pair<const char*, Behaviour>, 6> kBehaviours{{{"exploration", Behaviour::kExploration},
                                                                        {"stop", Behaviour::kStop},
                                                                        {"phototaxis", Behaviour::kPhototaxis},
                                                                        {"anti_phototaxis", Behaviour::kAntiPhototaxis},
                                                                        {"attraction", Behaviour::kAttraction},
                                                                        {"repulsion", Behaviour::kRepulsion}}};
constexpr std::array<std::pair<const char*, Condition>, 6> kConditions{{{"black_floor", Condition::kBlackFloor},
                                                                        {"gray_floor", Condition::kGrayFloor},
                                                                        {"white_floor", Condition::kWhiteFloor},
                                                                        {"many_neighbours", Condition::kManyNeighbours},
                                                                        {"few_neighbours", Condition::kFewNeighbours},
                                                                        {"always", Condition::kAlways}}};

/// The value of a child, given there by name. @param key of the child @throws ConfigError
template <class Value, std::size_t count>
Value named(const Configuration& element, const std::string& key,
            const std::array<std::pair<const char*, Value>, count>& values) {
  const std::string found = element.text(key);
  std::vector<std::string> names;
  for (const auto& [name, value] : values) {
    if (found == name) {
      return value;
    }
    names.emplace_back(name);
  }
  throw ConfigError(element.find(key)->location(), element.name() + ": " + unknownName("the " + key, found, names));
}

/// @throws ConfigError if the section is missing or empty
const Configuration& filledSection(const Configuration& parameters, const std::string& key) {
  const Configuration& found = requiredSection(parameters, key, "the machine");
  if (found.children().empty()) {
    throw ConfigError(found.location(), key + ": found nothing in it, allowed: at least one");
  }
  return found;
}

}  // namespace

double Transition::probabilityIn(const Surroundings& surroundings) const {
  const auto neighbours = static_cast<double>(surroundings.neighbours);
  switch (condition) {
    case Condition::kBlackFloor:
      return surroundings.floor == FloorShade::kBlack ? probability : 0.0;
    case Condition::kGrayFloor:
      return surroundings.floor == FloorShade::kGray ? probability : 0.0;
    case Condition::kWhiteFloor:
      return surroundings.floor == FloorShade::kWhite ? probability : 0.0;
    case Condition::kManyNeighbours:
      return probability / (1.0 + std::exp(steepness * (count - neighbours)));
    case Condition::kFewNeighbours:
      return probability / (1.0 + std::exp(steepness * (neighbours - count)));
    case Condition::kAlways:
      break;
  }
  return probability;
}

Machine::Machine(const Configuration& parameters) {
  const Configuration& states = filledSection(parameters, "states");
  for (const Configuration& state : states.children()) {
    readState(*states.find(state.name()));
  }
  states.refuseUnread();
  if (const Configuration* transitions = parameters.find("transitions"); transitions != nullptr) {
    for (const Configuration& transition : transitions->children()) {
      readTransition(*transitions->find(transition.name()));
    }
    transitions->refuseUnread();
  }
}

void Machine::readState(const Configuration& element) {
  MachineState state;
  state.name = element.name();
  state.behaviour = named(element, "behaviour", kBehaviours);
  std::vector<std::string> known{"behaviour"};
  if (state.behaviour == Behaviour::kExploration) {
    state.turning = static_cast<int>(element.integer("turning", 10, {1.0, 100.0}));
    known.emplace_back("turning");
  }
  if (state.behaviour == Behaviour::kAttraction || state.behaviour == Behaviour::kRepulsion) {
    state.strength = element.number("strength", 1.0, {0.01, 100.0});
    known.emplace_back("strength");
  }
  element.refuseUnread(known);
  states_.push_back(std::move(state));
}

void Machine::readTransition(const Configuration& element) {
  Transition transition;
  transition.from = stateOf(element, "from");
  transition.to = stateOf(element, "to");
  transition.condition = named(element, "condition", kConditions);
  transition.probability = element.number("probability", 1.0, {0.0, 1.0});
  std::vector<std::string> known{"from", "to", "condition", "probability"};
  if (transition.condition == Condition::kManyNeighbours || transition.condition == Condition::kFewNeighbours) {
    transition.count = element.number("count", {0.0, 100.0});
    transition.steepness = element.number("steepness", {0.0, 20.0});
    known.insert(known.end(), {"count", "steepness"});
  }
  element.refuseUnread(known);
  transitions_.push_back(transition);
}

std::size_t Machine::stateOf(const Configuration& element, const std::string& key) const {
  const std::string name = element.text(key);
  std::vector<std::string> names;
  for (std::size_t i = 0; i < states_.size(); ++i) {
    if (states_[i].name == name) {
      return i;
    }
    names.push_back(states_[i].name);
  }
  throw ConfigError(element.find(key)->location(),
                    element.name() + ": " + key + ": " + unknownName("the state", name, names));
}

bool Machine::advance(const Surroundings& surroundings, RandomStream& random) {
  for (const Transition& transition : transitions_) {
    if (transition.from != current_) {
      continue;
    }
    const double probability = transition.probabilityIn(surroundings);
    if (probability > 0.0 && random.uniform() < probability) {
      current_ = transition.to;
      return true;
    }
  }
  return false;
}

bool Machine::uses(Behaviour behaviour) const {
  return std::any_of(states_.begin(), states_.end(),
                     [&](const MachineState& state) { return state.behaviour == behaviour; });
}

bool Machine::uses(Condition condition) const {
  return std::any_of(transitions_.begin(), transitions_.end(),
                     [&](const Transition& transition) { return transition.condition == condition; });
}

}  // namespace swarmanoid

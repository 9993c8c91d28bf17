#include "swarmanoid_space/worlds/worlds.hpp"

#include <algorithm>
#include <exception>
#include <stdexcept>
#include <utility>

#include "../assembly/workers.hpp"
#include "agents.hpp"
#include "swarmanoid_interface/configuration.hpp"
#include "swarmanoid_space/models/limits.hpp"

namespace swarmanoid {
namespace {

/// @return the value @throws ConfigError if it is out of range
std::size_t checked(const char* option, std::size_t value, Range range) {
  if (!range.contains(static_cast<double>(value))) {
    throw ConfigError({option, 0}, "found " + std::to_string(value) + ", allowed: " + range.toString());
  }
  return value;
}

/// The id of the agents' configuration. @throws ConfigError
std::string controllerOf(const Experiment& experiment, const std::string& asked) {
  std::vector<std::string> known;
  for (const ControllerDescription& controller : experiment.controllers) {
    known.push_back(controller.id);
  }
  if (asked.empty() && known.size() == 1) {
    return known.front();
  }
  if (std::find(known.begin(), known.end(), asked) == known.end()) {
    std::sort(known.begin(), known.end());
    throw ConfigError({"controller", 0}, asked.empty() ? "found none, allowed: " + joinNames(known)
                                                       : unknownName("the controller", asked, known));
  }
  return asked;
}

/// @throws ConfigError if it is no number
double metricOf(const Simulation& simulation, const std::string& name) {
  const Metrics metrics = simulation.metrics();
  const auto found = metrics.find(name);
  if (found == metrics.end()) {
    std::vector<std::string> known;
    for (const auto& [each, value] : metrics) {
      known.push_back(each);
    }
    throw ConfigError({"reward", 0}, unknownName("the metric", name, known));
  }
  if (const auto* number = std::get_if<double>(&found->second)) {
    return *number;
  }
  if (const auto* truth = std::get_if<bool>(&found->second)) {
    return *truth ? 1.0 : 0.0;
  }
  throw ConfigError({"reward", 0}, "found '" + name + "', which is a text, allowed: a metric that is a number");
}

}  // namespace

struct Worlds::State {
  struct OneWorld {
    std::shared_ptr<Agents> agents;
    std::unique_ptr<Simulation> simulation;
    std::uint64_t seed = 0;
    double metric = 0.0;  // after the last step
    bool is_over = false;
    std::exception_ptr failure;
  };

  State(Options given, const Describe& describe, const Supplies& supplies);

  void add(std::size_t index, Experiment experiment, Supply supply);
  /// Starts the run of a world anew, and observes it.
  void restart(std::size_t index, std::uint64_t seed);
  void restore(std::size_t index, const Snapshot& snapshot);
  void observe(std::size_t index);
  /// Movable entities that are no agents, by number.
  std::vector<Row> othersOf(const OneWorld& world) const;
  /// Calls read(entities, row, numbers of the agent) for all agents. @param to [worlds][slots][numbers]
  template <class Read>
  void readAgents(std::size_t numbers, double* to, Read read) const;
  void judge(std::size_t index);
  void clearRewards(std::size_t index) { std::fill_n(&rewards[index * slots], slots, 0.0F); }
  template <class Number>
  void step(std::size_t index, const Number* actions);
  template <class Number>
  void advance(std::size_t index, const Number* actions);
  /// Calls action(world) for all worlds, on all threads. @throws the exception of the first world that has one
  template <class Action>
  void forAll(Action action);

  Options options;
  AgentFields observed;
  AgentFields commanded;
  Workers workers;
  std::vector<OneWorld> worlds;
  std::size_t slots = 0;
  std::size_t others = 0;  // movable entities of a world that are no agents, the most at the start
  std::vector<float> observations;
  std::vector<float> final_observations;
  std::vector<float> rewards;
  std::vector<std::uint8_t> present;
  std::vector<std::uint8_t> terminated;
  std::vector<std::uint8_t> truncated;
};

Worlds::State::State(Options given, const Describe& describe, const Supplies& supplies)
    : options(std::move(given)),
      observed(options.observations, DeviceKind::kSensor, "observations"),
      commanded(options.actions, DeviceKind::kActuator, "actions"),
      workers(static_cast<int>(checked("threads", options.threads, limits::kThreads))),
      worlds(checked("count", options.count, {1.0, 1e6})) {
  checked("ticks_per_step", options.ticks_per_step, {1.0, 1e9});
  for (std::size_t i = 0; i < worlds.size(); ++i) {
    add(i, describe(i), supplies(i));
    slots = std::max(slots, worlds[i].agents->slotCount());
  }
  for (const OneWorld& world : worlds) {
    others = std::max(others, othersOf(world).size());
  }
  if (slots == 0) {
    throw ConfigError({"controller", 0},
                      "found no robot that controller '" + options.controller + "' commands, allowed: one or more");
  }
  observations.resize(worlds.size() * slots * observed.size());
  final_observations.resize(options.autoreset == Autoreset::kSameStep ? observations.size() : 0);
  rewards.resize(worlds.size() * slots);
  present.resize(worlds.size() * slots);
  terminated.resize(worlds.size());
  truncated.resize(worlds.size());
  for (OneWorld& world : worlds) {
    world.agents->limitSlots(slots);
  }
  forAll([this](std::size_t i) {
    observe(i);
    judge(i);
  });
}

void Worlds::State::add(std::size_t index, Experiment experiment, Supply supply) {
  OneWorld& world = worlds[index];
  options.controller = controllerOf(experiment, options.controller);
  if (worlds.size() > 1) {
    experiment.framework.threads = 1;
  }
  world.seed = experiment.framework.seed;
  world.agents = std::make_shared<Agents>(observed, commanded);
  supply.context.keeps_start = true;
  supply.parts.group_controllers[options.controller] = world.agents;
  world.simulation =
      std::make_unique<Simulation>(std::move(experiment), std::move(supply.context), std::move(supply.parts));
  world.simulation->start();
  world.agents->markAll();
  world.metric = options.reward.empty() ? 0.0 : metricOf(*world.simulation, options.reward);
}

template <class Action>
void Worlds::State::forAll(Action action) {
  constexpr std::size_t kBlock = 8;  // worlds that a thread takes at once
  const std::size_t blocks = (worlds.size() + kBlock - 1) / kBlock;
  workers.forEach(blocks, [&](std::size_t block) {
    for (std::size_t i = block * kBlock; i < std::min(worlds.size(), (block + 1) * kBlock); ++i) {
      try {
        action(i);
      } catch (...) {
        worlds[i].failure = std::current_exception();
        worlds[i].is_over = true;
      }
    }
  });
  for (std::size_t i = 0; i < worlds.size(); ++i) {
    if (const std::exception_ptr failure = std::exchange(worlds[i].failure, nullptr)) {
      try {
        std::rethrow_exception(failure);
      } catch (const std::exception& error) {
        throw std::runtime_error("world " + std::to_string(i) + ": " + error.what());
      }
    }
  }
}

void Worlds::State::restart(std::size_t index, std::uint64_t seed) {
  OneWorld& world = worlds[index];
  world.seed = seed;
  world.agents->setActions(nullptr);
  world.simulation->reset(seed, true);
  world.agents->markAll();
  world.metric = options.reward.empty() ? 0.0 : metricOf(*world.simulation, options.reward);
  world.is_over = false;
  observe(index);
}

void Worlds::State::restore(std::size_t index, const Snapshot& snapshot) {
  OneWorld& world = worlds[index];
  world.seed = snapshot.seed();
  world.agents->setActions(nullptr);
  world.simulation->restore(snapshot);
  world.metric = options.reward.empty() ? 0.0 : metricOf(*world.simulation, options.reward);
  observe(index);
}

void Worlds::State::observe(std::size_t index) {
  OneWorld& world = worlds[index];
  world.simulation->sense();
  world.agents->observe(world.simulation->space(), &observations[index * slots * observed.size()],
                        &present[index * slots]);
}

/// Decides whether the run of a world is over.
void Worlds::State::judge(std::size_t index) {
  const Simulation& simulation = *worlds[index].simulation;
  const auto first = present.begin() + static_cast<std::ptrdiff_t>(index * slots);
  const bool is_empty =
      std::find(first, first + static_cast<std::ptrdiff_t>(slots), 1) == first + static_cast<std::ptrdiff_t>(slots);
  const bool is_at_end = simulation.space().tick >= simulation.experiment().framework.max_clock;
  truncated[index] = is_at_end ? 1 : 0;
  terminated[index] = (simulation.isFinished() && !is_at_end) || is_empty ? 1 : 0;
  worlds[index].is_over = terminated[index] != 0 || truncated[index] != 0;
}

template <class Number>
void Worlds::State::advance(std::size_t index, const Number* actions) {
  OneWorld& world = worlds[index];
  world.agents->setActions(actions + index * slots * commanded.size());
  for (std::size_t tick = 0; tick < options.ticks_per_step && !world.simulation->isFinished(); ++tick) {
    world.simulation->tick();
  }
  observe(index);
  if (!options.reward.empty()) {
    const double metric = metricOf(*world.simulation, options.reward);
    const auto reward = static_cast<float>(metric - world.metric);
    world.metric = metric;
    for (std::size_t slot = index * slots; slot < (index + 1) * slots; ++slot) {
      rewards[slot] = present[slot] != 0 ? reward : 0.0F;
    }
  }
}

template <class Number>
void Worlds::State::step(std::size_t index, const Number* actions) {
  OneWorld& world = worlds[index];
  if (!final_observations.empty()) {
    std::fill_n(&final_observations[index * slots * observed.size()], slots * observed.size(), 0.0F);
  }
  if (world.is_over) {
    clearRewards(index);
    if (options.autoreset != Autoreset::kDisabled) {
      restart(index, world.seed + worlds.size());
      judge(index);
    }
    return;
  }
  advance(index, actions);
  judge(index);
  if (world.is_over && options.autoreset == Autoreset::kSameStep) {
    const std::size_t numbers = slots * observed.size();
    std::copy_n(&observations[index * numbers], numbers, &final_observations[index * numbers]);
    restart(index, world.seed + worlds.size());
  }
}

Worlds::Worlds(Options options, const Describe& describe)
    : Worlds(std::move(options), describe, [](std::size_t) {
        Supply supply;
        supply.context.is_open = false;
        return supply;
      }) {}

Worlds::Worlds(Options options, const Describe& describe, const Supplies& supplies)
    : state_(std::make_unique<State>(std::move(options), describe, supplies)) {}

Worlds::~Worlds() = default;

const Worlds::Options& Worlds::options() const { return state_->options; }
std::size_t Worlds::slots() const { return state_->slots; }
std::size_t Worlds::observationSize() const { return state_->observed.size(); }
std::size_t Worlds::actionSize() const { return state_->commanded.size(); }

void Worlds::reset(const std::uint8_t* chosen, const std::uint64_t* seeds) {
  state_->forAll([&](std::size_t i) {
    if (chosen == nullptr || chosen[i] != 0) {
      state_->clearRewards(i);
      state_->restart(i, seeds == nullptr ? state_->worlds[i].seed + count() : seeds[i]);
      state_->judge(i);
    }
  });
}

std::shared_ptr<const Snapshot> Worlds::snapshot(std::size_t world) const {
  return state_->worlds.at(world).simulation->snapshot();
}

void Worlds::restore(const Snapshot& snapshot, const std::uint8_t* chosen) {
  state_->forAll([&](std::size_t i) {
    if (chosen == nullptr || chosen[i] != 0) {
      state_->clearRewards(i);
      state_->restore(i, snapshot);
      state_->judge(i);
    }
  });
}

void Worlds::step(const float* actions) {
  state_->forAll([&](std::size_t i) { state_->step(i, actions); });
}

void Worlds::step(const double* actions) {
  state_->forAll([&](std::size_t i) { state_->step(i, actions); });
}

void Worlds::observe() {
  state_->forAll([&](std::size_t i) {
    state_->observe(i);
    state_->judge(i);
  });
}

float* Worlds::observations() { return state_->observations.data(); }
float* Worlds::finalObservations() { return state_->final_observations.data(); }
float* Worlds::rewards() { return state_->rewards.data(); }
std::uint8_t* Worlds::present() { return state_->present.data(); }
std::uint8_t* Worlds::terminated() { return state_->terminated.data(); }
std::uint8_t* Worlds::truncated() { return state_->truncated.data(); }

template <class Read>
void Worlds::State::readAgents(std::size_t numbers, double* to, Read read) const {
  std::fill_n(to, worlds.size() * slots * numbers, 0.0);
  for (std::size_t i = 0; i < worlds.size(); ++i) {
    const Space& space = worlds[i].simulation->space();
    worlds[i].agents->visit(
        space, [&](std::size_t slot, Row row) { read(space.entities, row, to + (i * slots + slot) * numbers); });
  }
}

void Worlds::readPoses(double* poses) const {
  state_->readAgents(7, poses, [](const Entities& entities, Row row, double* to) {
    Eigen::Map<Eigen::Vector3d>{to} = entities.pose[row].position;
    Eigen::Map<Eigen::Vector4d>{to + 3} = entities.pose[row].orientation.coeffs();
  });
}

void Worlds::readTwists(double* twists) const {
  state_->readAgents(6, twists, [](const Entities& entities, Row row, double* to) {
    Eigen::Map<Eigen::Vector3d>{to} = entities.twist[row].linear;
    Eigen::Map<Eigen::Vector3d>{to + 3} = entities.twist[row].angular;
  });
}

std::vector<Row> Worlds::State::othersOf(const OneWorld& world) const {
  const Space& space = world.simulation->space();
  std::vector<Row> agents;
  world.agents->visit(space, [&](std::size_t /*slot*/, Row row) { agents.push_back(row); });
  std::vector<Row> rows;
  for (const Row row : space.entities.order) {
    if (space.entities.model[row]->is_movable && std::find(agents.begin(), agents.end(), row) == agents.end()) {
      rows.push_back(row);
    }
  }
  return rows;
}

std::size_t Worlds::stateRows() const { return slots() + state_->others; }

void Worlds::readState(double* numbers) const {
  std::fill_n(numbers, count() * stateRows() * kStateNumbers, 0.0);
  for (std::size_t i = 0; i < count(); ++i) {
    const State::OneWorld& one = state_->worlds[i];
    const Space& space = one.simulation->space();
    const auto write = [&](std::size_t place, Row row) {
      double* to = numbers + (i * stateRows() + place) * kStateNumbers;
      *to++ = 1.0;
      Eigen::Map<Eigen::Vector3d>{to} = space.entities.pose[row].position;
      Eigen::Map<Eigen::Vector4d>{to + 3} = space.entities.pose[row].orientation.coeffs();
      Eigen::Map<Eigen::Vector3d>{to + 7} = space.entities.twist[row].linear;
      Eigen::Map<Eigen::Vector3d>{to + 10} = space.entities.twist[row].angular;
    };
    one.agents->visit(space, write);
    const std::vector<Row> rows = state_->othersOf(one);
    for (std::size_t k = 0; k < std::min(rows.size(), state_->others); ++k) {
      write(slots() + k, rows[k]);
    }
  }
}

std::vector<Row> Worlds::rowsOf(std::size_t world) const {
  std::vector<Row> rows(slots(), kNoRow);
  const State::OneWorld& one = state_->worlds.at(world);
  one.agents->visit(one.simulation->space(), [&](std::size_t slot, Row row) {
    if (state_->present[world * slots() + slot] != 0) {
      rows[slot] = row;
    }
  });
  return rows;
}

std::vector<std::vector<Range>> Worlds::boundsOf(const std::vector<std::string>& names, DeviceKind kind) {
  return AgentFields(names, kind, kind == DeviceKind::kSensor ? "observations" : "actions").bounds();
}

const Simulation& Worlds::world(std::size_t world) const { return *state_->worlds.at(world).simulation; }
Simulation& Worlds::world(std::size_t world) { return *state_->worlds.at(world).simulation; }

}  // namespace swarmanoid

// The names of an experiment's robots, and the selection of robots by a list of names.
#include "swarmanoid_interface/contains.hpp"
#include "swarmanoid_space/experiment/experiment.hpp"

namespace swarmanoid {

std::vector<std::string> robotNames(const Experiment& experiment, std::optional<CommandSource> source) {
  std::vector<std::string> names;
  for (const EntityDescription& entity : experiment.arena.entities) {
    if (entity.controller.empty() || (source && entity.source != *source)) {
      continue;
    }
    if (!entity.distribution) {
      names.push_back(entity.id);
      continue;
    }
    for (std::size_t k = 1; k <= entity.distribution->quantity; ++k) {
      names.push_back(entity.id + "_" + std::to_string(k));
    }
  }
  return names;
}

std::vector<std::string> chooseRobots(const std::vector<std::string>& words, const std::string& parameter,
                                      const Experiment& experiment) {
  std::vector<std::string> names = robotNames(experiment);
  if (words == std::vector<std::string>{"all"}) {
    return names;
  }
  if (words == std::vector<std::string>{"none"}) {
    return {};
  }
  for (const std::string& robot : words) {
    if (!contains(names, robot)) {
      throw ConfigError({experiment.file, 0}, parameter + ": found '" + robot + "', allowed: all, none, " +
                                                  joinNames(names) + didYouMean(robot, names));
    }
  }
  return words;
}

}  // namespace swarmanoid

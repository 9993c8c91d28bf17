/// Reads recorded controllers from a bag: the topics /<robot>/controller/start, .../sensors and .../commands, written
/// by the simulator's recorder, or by rosbag record with a robot's host.
#pragma once

#include <string>
#include <vector>

#include "recording.hpp"

namespace swarmanoid::replay {

struct ParameterValue {
  std::string name;  ///< for nested ones a path: outer/inner
  std::string value;
  SourceLocation location;  ///< source of the value, for messages about it
};

/// @param robots to read; none: all robots in the bag
/// @param parameters replace the controllers' recorded parameters of the same names, or are added to them
/// @throws ConfigError for a bag that cannot be read, has no recorded controller, or lacks one of the requested robots
Recording readBag(const std::string& file, const std::vector<std::string>& robots = {},
                  const std::vector<ParameterValue>& parameters = {});

/// Reads "name=value", or a file with a line "name: value" for each; # begins a comment.
/// @throws ConfigError
std::vector<ParameterValue> readParameters(const std::string& word);

}  // namespace swarmanoid::replay

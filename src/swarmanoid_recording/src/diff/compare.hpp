/// Compares two records of one tick, field by field.
#pragma once

#include <string>
#include <vector>

#include "recorded_tick.hpp"

namespace swarmanoid::diff {

/// One field that differs. Numbers are short and exact: reading them gives the same bits.
struct Difference {
  std::string field;  ///< "fb_1/pose/position/x", "fb_1/reading footbot_proximity/4", "fb_1/command footbot_wheels/0"
  std::string first;
  std::string second;
};

/// One side of a comparison.
struct Side {
  const RecordedTick& tick;
  const RobotDescriptions& robots;
};

/// Returns the differences in the order of a tick: readings, commands, then the state at its end. Numbers are equal if
/// their bits are; -0 and 0 are equal, as for the state hash, and so are all NaNs. @pre both are of the same tick
/// @throws ConfigError for frames that do not fit the robot's description
std::vector<Difference> compare(const Side& first, const Side& second);

}  // namespace swarmanoid::diff

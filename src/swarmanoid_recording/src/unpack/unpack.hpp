/// Extracts the folder of a run's record (docs/reference/run_record.md) from its bag.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace swarmanoid::unpack {

struct Choice {
  std::optional<std::uint64_t> run;  ///< counted by resets; none: the last one with a tick
  bool only_interventions = false;   ///< which bags without a record contain too
};

/// Writes the files of the record.
/// @param folder exists and is empty @throws ConfigError if the bag cannot be read, or lacks the requested data
void unpack(const std::string& bag, const std::string& folder, const Choice& choice);

}  // namespace swarmanoid::unpack

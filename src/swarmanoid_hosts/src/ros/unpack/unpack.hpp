/// Makes the folder of a run's record (docs/reference/run_record.md) of what is in its bag.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace swarmanoid::unpack {

struct Choice {
  std::optional<std::uint64_t> run;  ///< as resets count them; none: the last one that made a tick
  bool only_interventions = false;   ///< which bags without a record have too
};

/// Writes the files of the record.
/// @param folder that is there, and empty @throws ConfigError if the bag cannot be read, or lacks what is asked for
void unpack(const std::string& bag, const std::string& folder, const Choice& choice);

}  // namespace swarmanoid::unpack

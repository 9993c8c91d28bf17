/// The state of an engine, for diagnostics.
#pragma once

#include <cstddef>
#include <string>

#include "swarmanoid_space/engine.hpp"

namespace swarmanoid {

struct EngineReport {
  std::string id;
  std::string label;
  std::size_t moved = 0;     ///< entities that it moves
  std::size_t mirrored = 0;  ///< entities that it keeps a mirror of
  EngineHealth health;
};

}  // namespace swarmanoid

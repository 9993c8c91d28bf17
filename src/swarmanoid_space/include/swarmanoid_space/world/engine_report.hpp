/// The state of an engine, for diagnostics.
#pragma once

#include <cstddef>
#include <string>

#include "swarmanoid_space/engine.hpp"

namespace swarmanoid {

struct EngineReport {
  std::string id;
  std::string label;
  std::size_t moved = 0;     ///< entities moved by this engine
  std::size_t mirrored = 0;  ///< entities mirrored in this engine
  EngineHealth health;
};

}  // namespace swarmanoid

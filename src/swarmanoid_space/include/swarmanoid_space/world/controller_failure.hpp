/// A robot whose controller has failed.
#pragma once

#include <cstdint>
#include <string>

namespace swarmanoid {

/// The controller threw in a step (or in destroy), or commanded a number that is not finite.
struct ControllerFailure {
  std::string robot;
  std::uint64_t tick = 0;
  std::string reason;
};

}  // namespace swarmanoid

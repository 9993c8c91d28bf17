// Phase 1: banks of sensors read the space and fill the readings.
#include "tick.hpp"

namespace swarmanoid::phases {

void sense(Space& space, const std::vector<std::unique_ptr<ControllerGroup>>& groups, const Workers& workers) {
  constexpr std::size_t kGrain = 128;
  const Space& seen = space;
  for (const auto& group : groups) {
    for (const auto& sensor : group->sensors) {
      workers.forRanges(sensor->seatCount(), kGrain,
                        [&](std::size_t first, std::size_t last) { sensor->sense(seen, first, last); });
      sensor->report(space);
    }
  }
}

}  // namespace swarmanoid::phases

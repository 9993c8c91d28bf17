// Phase 1: sensor banks read the space and fill in the readings, which are then disturbed by their errors.
#include "phases.hpp"
#include "swarmanoid_interface/process/user_code.hpp"

namespace swarmanoid::phases {

void sense(const Space& space, const std::vector<std::unique_ptr<ControllerGroup>>& groups, const Workers& workers) {
  constexpr std::size_t kGrain = 128;
  for (const auto& group : groups) {
    for (const auto& sensor : group->sensors) {
      callPlugin("sense", sensor.part, space.tick, [&] { sensor->prepare(space); });
      workers.forRanges(sensor->instanceCount(), kGrain, [&](std::size_t first, std::size_t last) {
        callPlugin("sense", sensor.part, space.tick, [&] { sensor->update(space, first, last); });
      });
    }
  }
}

void report(const Space& space, const ReportAccess& access,
            const std::vector<std::unique_ptr<ControllerGroup>>& groups) {
  for (const auto& group : groups) {
    for (const auto& sensor : group->sensors) {
      callPlugin("report", sensor.part, space.tick, [&] { sensor->report(space, access); });
    }
  }
}

}  // namespace swarmanoid::phases

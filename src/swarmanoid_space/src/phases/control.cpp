// Phase 2: every controller of this process turns readings into commands.
#include "phases.hpp"
#include "swarmanoid_interface/step_controller.hpp"

namespace swarmanoid::phases {

void control(Space& space, std::vector<Driver>& drivers, const Workers& workers) {
  constexpr std::size_t kGrain = 64;
  workers.forRanges(drivers.size(), kGrain, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      Driver& driver = drivers[i];
      if (driver.source == CommandSource::kRemote) {
        continue;  // its participant has answered
      }
      StepStatus& status = space.controllers[static_cast<std::size_t>(driver.row)].status;
      status = StepStatus::kNothing;
      if (!driver.has_failed && driver.controller != nullptr) {
        driver.has_failed = !stepController(*driver.controller, driver.step, *driver.robot, space.tick, space.time,
                                            space.clocktick, driver.failure);
        status = driver.has_failed ? StepStatus::kFailed : StepStatus::kStepped;
      }
    }
  });
}

}  // namespace swarmanoid::phases

// Phase 2: every controller of this process turns readings into commands.
#include "phases.hpp"
#include "swarmanoid_interface/step_controller.hpp"

namespace swarmanoid::phases {

void control(const Space& space, ByRow<ControllerState>& states, std::vector<RobotInstance>& instances,
             const Workers& workers) {
  constexpr std::size_t kGrain = 64;
  workers.forRanges(instances.size(), kGrain, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      RobotInstance& instance = instances[i];
      if (instance.source == CommandSource::kRemote) {
        continue;  // its participant has answered
      }
      StepStatus& status = states[instance.row].status;
      status = StepStatus::kNothing;
      if (!instance.has_failed && instance.controller != nullptr) {
        instance.has_failed = !stepController(*instance.controller, instance.step, *instance.robot, space.tick,
                                              space.time, space.clocktick, instance.failure);
        status = instance.has_failed ? StepStatus::kFailed : StepStatus::kStepped;
      }
    }
  });
}

}  // namespace swarmanoid::phases

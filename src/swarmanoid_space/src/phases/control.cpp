// Phase 2: every controller of this process turns readings into commands. On the way over all robots it is found out
// whether any of them needs more than that: few ticks have to go over them again.
#include <atomic>

#include "phases.hpp"
#include "swarmanoid_interface/step_controller.hpp"

namespace swarmanoid::phases {
namespace {

/// Steps all robots of a group by one call.
void stepTogether(const Space& space, Banks& commands, ByRow<ControllerState>& states, ControllerGroup& group,
                  std::vector<RobotInstance>& instances) {
  group.members.clear();
  for (const RobotInstance& instance : instances) {
    if (instance.group == &group && instance.source == CommandSource::kController && !instance.has_failed) {
      instance.robot->startTick(space.tick, space.time);
      group.members.push_back({instance.row, instance.robot});
    }
  }
  const Span<const GroupMember> members(group.members.data(), group.members.size());
  const std::string failure =
      failureOf({"step", group.part, "", space.tick}, [&] { group.together->step(space, commands, members); });
  for (RobotInstance& instance : instances) {
    if (instance.group != &group || instance.source != CommandSource::kController || instance.has_failed) {
      continue;
    }
    instance.has_failed = !failure.empty();
    instance.failure = failure;
    states[instance.row].status = instance.has_failed ? StepStatus::kFailed : StepStatus::kStepped;
  }
}

}  // namespace

Found control(const Space& space, Banks& commands, ByRow<ControllerState>& states,
              const std::vector<std::unique_ptr<ControllerGroup>>& groups, std::vector<RobotInstance>& instances,
              const Workers& workers) {
  constexpr std::size_t kGrain = 64;
  std::atomic<bool> is_failure{false};
  std::atomic<bool> is_stop{false};
  workers.forRanges(instances.size(), kGrain, [&](std::size_t first, std::size_t last) {
    Found found;
    for (std::size_t i = first; i < last; ++i) {
      RobotInstance& instance = instances[i];
      found.is_stop = found.is_stop || instance.stops_since.has_value();
      found.is_failure = found.is_failure || instance.has_failed;
      if (instance.source == CommandSource::kRemote) {
        continue;  // its participant has answered
      }
      StepStatus& status = states[instance.row].status;
      status = StepStatus::kNothing;
      if (!instance.has_failed && instance.controller != nullptr) {
        instance.has_failed = !stepController(*instance.controller, instance.step, *instance.robot, space.tick,
                                              space.time, space.clocktick, instance.failure);
        status = instance.has_failed ? StepStatus::kFailed : StepStatus::kStepped;
        found.is_failure = found.is_failure || instance.has_failed;
      }
    }
    if (found.is_failure) {
      is_failure = true;
    }
    if (found.is_stop) {
      is_stop = true;
    }
  });
  for (const auto& group : groups) {
    if (group->together != nullptr) {
      stepTogether(space, commands, states, *group, instances);
      is_failure = true;  // each of them may have failed
    }
  }
  return {is_failure, is_stop};
}

}  // namespace swarmanoid::phases

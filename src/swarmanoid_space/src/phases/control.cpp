// Phase 2: every controller of this process turns readings into commands. The same pass finds out whether any robot
// needs further processing, so that few ticks need another pass.
#include <atomic>

#include "phases.hpp"
#include "swarmanoid_interface/step_controller.hpp"

namespace swarmanoid::phases {
namespace {

/// Steps all robots of a group in one call. @return whether any of them has failed
bool stepTogether(const Space& space, const ControlAccess& access, ControllerGroup& group,
                  std::vector<RobotInstance>& instances) {
  group.members.clear();
  group.stepped.clear();
  for (RobotInstance& instance : instances) {
    if (instance.group == &group && instance.source == CommandSource::kController && !instance.has_failed) {
      instance.robot->startTick(space.tick, space.time);
      group.members.push_back({instance.row, instance.robot, &instance.failure});
      group.stepped.push_back(&instance);
    }
  }
  const Span<const GroupMember> members(group.members.data(), group.members.size());
  const std::string failure =
      failureOf({"step", group.part, "", space.tick}, [&] { group.together->step(space, access.commands, members); });
  bool is_failure = false;
  for (RobotInstance* instance : group.stepped) {
    if (!failure.empty()) {
      instance->failure = failure;
    }
    instance->has_failed = !instance->failure.empty();
    is_failure = is_failure || instance->has_failed;
    access.controllers[instance->row].status = instance->has_failed ? StepStatus::kFailed : StepStatus::kStepped;
  }
  return is_failure;
}

}  // namespace

Found control(const Space& space, const ControlAccess& access,
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
      StepStatus& status = access.controllers[instance.row].status;
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
      is_failure = stepTogether(space, access, *group, instances) || is_failure;
    }
  }
  return {is_failure, is_stop};
}

}  // namespace swarmanoid::phases

// Last part of phase 5: handover rules check the new poses and grips, and the debug values of controllers.

#include "phases.hpp"

namespace swarmanoid::phases {
namespace {

void attempt(const Space& space, const HandOverAccess& access, std::vector<Event>& events,
             const std::vector<Named<Engine>>& engines, const std::vector<RobotInstance>& instances,
             HandoverTrigger& trigger, ByRow<std::vector<Membership>>& memberships) {
  if (space.mover[trigger.row] == trigger.engine) {
    trigger.is_due = false;
    return;
  }
  Handover handover(space, access, engines, instances, memberships, trigger.row, *trigger.engine);
  const std::string problem = handover.problem();
  if (problem.empty()) {
    handover.commit(events);
    trigger.is_due = false;
  } else if (!trigger.is_refused) {
    trigger.is_refused = true;  // reported once; tried again each tick, because the obstacle may disappear
    events.push_back({Event::Kind::kHandoverRefused, space.entities.name[trigger.row], "",
                      "to " + trigger.engine->id() + ": " + problem});
  }
}

}  // namespace

void handOver(const Space& space, const HandOverAccess& access, std::vector<Event>& events,
              const std::vector<Named<Engine>>& engines, const std::vector<RobotInstance>& instances,
              std::vector<HandoverTrigger>& triggers, ByRow<std::vector<Membership>>& memberships) {
  for (HandoverTrigger& trigger : triggers) {
    if (space.entities.number[trigger.row] != trigger.number) {
      continue;  // deleted; another entity may have its row now
    }
    const bool is_true = holds(*trigger.rule, space, trigger.row);
    if (is_true != trigger.was_true) {
      trigger.is_due = is_true;
      trigger.is_refused = false;
    }
    trigger.was_true = is_true;
    if (trigger.is_due) {
      attempt(space, access, events, engines, instances, trigger, memberships);
    }
  }
}

}  // namespace swarmanoid::phases

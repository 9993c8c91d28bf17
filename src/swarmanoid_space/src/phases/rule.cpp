// Phase 8: rules read the world, and request changes before the next tick.
#include "../assembly/call_rule.hpp"
#include "phases.hpp"

namespace swarmanoid::phases {

bool rule(const Space& space, std::vector<Event>& events, const std::vector<RuleInstance>& rules,
          InterventionQueue& queue) {
  bool finish_asked = false;
  for (const RuleInstance& rule : rules) {
    queue.setAsking(rule.part);
    callRule("afterTick", rule, space.tick, [&] {
      rule->afterTick(space, queue);
      if (rule->isFinished()) {
        finish_asked = true;
        events.push_back({Event::Kind::kFinished, "", "", rule.part + " ends the run"});
      }
    });
  }
  return finish_asked;
}

}  // namespace swarmanoid::phases

// Rules at the beginning of a run and of a tick; phases/rule.cpp has the rest.
#include "../assembly/call_rule.hpp"
#include "../interventions/carry_out.hpp"
#include "../world/world.hpp"
#include "swarmanoid_space/simulation/simulation.hpp"

namespace swarmanoid {

void Simulation::resetRules() {
  World& world = *world_;
  world.queue.clear();
  rules_have_begun_ = false;
  has_sensed_ = false;
  for (const RuleInstance& rule : world.assembly.rules) {
    world.queue.setAsking(rule.part);
    rule->begin(world.space.seed);
    callRule("reset", rule, UserCode::kNoTick, [&] { rule->reset(world.space, world.queue); });
    takeAsked(world);
  }
}

void Simulation::beginTick() {
  if (rules_have_begun_) {
    return;  // already done in an attempt at this tick that was given up
  }
  World& world = *world_;
  playInterventions(false);
  takeAsked(world);
  for (const RuleInstance& rule : world.assembly.rules) {
    world.queue.setAsking(rule.part);
    rule->startTick(world.space.tick);
    callRule("beforeTick", rule, world.space.tick, [&] { rule->beforeTick(world.space, world.queue); });
    takeAsked(world);
  }
  switchPower();  // later changes of charge, also in a repeated tick, take effect in the next tick
  rules_have_begun_ = true;
  playInterventions(true);
}

}  // namespace swarmanoid

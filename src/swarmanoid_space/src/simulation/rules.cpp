// Rules at the beginning of a run and of a tick. What they do in between is in phases/rule.cpp.
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
    return;  // an attempt at this tick was given up after this
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
  switchPower();  // what comes after the rules, also in a tick that is made again, counts in the next one
  rules_have_begun_ = true;
  playInterventions(true);
}

}  // namespace swarmanoid

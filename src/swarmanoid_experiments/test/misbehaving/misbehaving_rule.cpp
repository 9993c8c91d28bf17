// A misbehaving rule. phase: configure, reset; beforeTick, afterTick (with a clock of 3 ticks).
#include "actions.hpp"
#include "swarmanoid_space/rule.hpp"

namespace swarmanoid::test {
namespace {

class MisbehavingRule final : public Rule {
 public:
  static PluginDescription describe() { return Misbehaviour::describe("misbehaving_rule"); }

  void configure(const Configuration& parameters) override { misbehaviour_.configure(parameters); }
  void reset(const Space&, InterventionQueue&) override { misbehaviour_.tryIn("reset"); }
  void beforeTick(const Space& space, InterventionQueue&) override { misbehaviour_.tryIn("beforeTick", space.tick); }
  void afterTick(const Space& space, InterventionQueue&) override { misbehaviour_.tryIn("afterTick", space.tick); }

 private:
  Misbehaviour misbehaviour_;
};

}  // namespace
}  // namespace swarmanoid::test

REGISTER_RULE(swarmanoid::test::MisbehavingRule)

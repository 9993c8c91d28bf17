// The same for a rule. phase: configure, reset; beforeTick, afterTick (with a clock of 3 ticks).
#include "deeds.hpp"
#include "swarmanoid_space/rule.hpp"

namespace swarmanoid::test {
namespace {

class MisbehavingRule final : public Rule {
 public:
  static PluginDescription describe() { return Misdeed::describe("misbehaving_rule"); }

  void configure(const Configuration& parameters) override { misdeed_.configure(parameters); }
  void reset(const Space&, InterventionQueue&) override { misdeed_.tryIn("reset"); }
  void beforeTick(const Space& space, InterventionQueue&) override { misdeed_.tryIn("beforeTick", space.tick); }
  void afterTick(const Space& space, InterventionQueue&) override { misdeed_.tryIn("afterTick", space.tick); }

 private:
  Misdeed misdeed_;
};

}  // namespace
}  // namespace swarmanoid::test

REGISTER_RULE(swarmanoid::test::MisbehavingRule)

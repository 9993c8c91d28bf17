// The same for an observer. phase: configure, draw (after tick 3), flush, finish; deed: one of deeds.cpp.
#include <string>

#include "deeds.hpp"
#include "swarmanoid_space/observer.hpp"

namespace swarmanoid::test {
namespace {

class MisbehavingVisualisation final : public Observer {
 public:
  static PluginDescription describe() { return Misdeed::describe("misbehaving_visualisation"); }

  void configure(const std::string& id, const Configuration& parameters, const RunContext&) override {
    id_ = id;
    misdeed_.configure(parameters);
  }

  void draw(const Space& space) override { misdeed_.tryIn("draw", space.tick); }
  void flush() override { misdeed_.tryIn("flush"); }
  void finish() override { misdeed_.tryIn("finish"); }

 private:
  Misdeed misdeed_;
};

}  // namespace
}  // namespace swarmanoid::test

REGISTER_OBSERVER(swarmanoid::test::MisbehavingVisualisation)

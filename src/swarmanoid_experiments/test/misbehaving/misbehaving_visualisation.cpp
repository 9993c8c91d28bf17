// A misbehaving observer. phase: configure, draw (after tick 3), flush, finish; action: one of actions.cpp.
#include <string>

#include "actions.hpp"
#include "swarmanoid_space/observer.hpp"

namespace swarmanoid::test {
namespace {

class MisbehavingVisualisation final : public Observer {
 public:
  static PluginDescription describe() { return Misbehaviour::describe("misbehaving_visualisation"); }

  void configure(const std::string& id, const Configuration& parameters, const RunContext&) override {
    id_ = id;
    misbehaviour_.configure(parameters);
  }

  void draw(const Space& space) override { misbehaviour_.tryIn("draw", space.tick); }
  void flush() override { misbehaviour_.tryIn("flush"); }
  void finish() override { misbehaviour_.tryIn("finish"); }

 private:
  Misbehaviour misbehaviour_;
};

}  // namespace
}  // namespace swarmanoid::test

REGISTER_OBSERVER(swarmanoid::test::MisbehavingVisualisation)

// The same for an engine, which need not hold anything. phase: configure; readMirrors, move, connect (in tick 3);
// invalidPoseReason, which is called when somebody is to be handed over to it.
#include "../glide_engine.hpp"
#include "deeds.hpp"

namespace swarmanoid::test {
namespace {

class MisbehavingEngine final : public GlideEngine {
 public:
  static PluginDescription describe() { return Misdeed::describe("misbehaving_engine"); }

  void configure(const std::string& id, const Configuration& parameters) override {
    id_ = id;
    misdeed_.configure(parameters);
  }

  std::string invalidPoseReason(const EntityModel&, const Pose&) const override {
    misdeed_.tryIn("invalidPoseReason");
    return "";
  }
  void readMirrors(const Space& space) override { misdeed_.tryIn("readMirrors", space.tick); }
  void move(Space& space, Duration dt) override {
    GlideEngine::move(space, dt);
    expose(space);
    misdeed_.tryIn("move", space.tick);
  }
  void connect(Space& space) override { misdeed_.tryIn("connect", space.tick); }

 private:
  Misdeed misdeed_;
};

}  // namespace
}  // namespace swarmanoid::test

REGISTER_ENGINE(swarmanoid::test::MisbehavingEngine)

// A misbehaving engine, which may be empty. phase: configure; readMirrors, move, connect (in tick 3);
// invalidPoseReason, which is called before an entity is handed over to it.
#include "../glide_engine.hpp"
#include "actions.hpp"

namespace swarmanoid::test {
namespace {

class MisbehavingEngine final : public GlideEngine {
 public:
  static PluginDescription describe() { return Misbehaviour::describe("misbehaving_engine"); }

  void configure(const std::string& id, const Configuration& parameters) override {
    id_ = id;
    misbehaviour_.configure(parameters);
  }

  std::string invalidPoseReason(const EntityModel&, const Pose&) const override {
    misbehaviour_.tryIn("invalidPoseReason");
    return "";
  }
  void readMirrors(const Space& space) override { misbehaviour_.tryIn("readMirrors", space.tick); }
  void move(const Space& space, const MoveAccess& access, Duration dt) override {
    GlideEngine::move(space, access, dt);
    expose(space);
    misbehaviour_.tryIn("move", space.tick);
  }
  void connect(const Space& space, const ConnectAccess&) override { misbehaviour_.tryIn("connect", space.tick); }

 private:
  Misbehaviour misbehaviour_;
};

}  // namespace
}  // namespace swarmanoid::test

REGISTER_ENGINE(swarmanoid::test::MisbehavingEngine)

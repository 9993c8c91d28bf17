// The same for a visualisation. phase: configure, draw (after tick 3), finish; deed: one of deeds.cpp.
#include <string>

#include "deeds.hpp"
#include "swarmanoid_space/visualisation.hpp"

namespace swarmanoid::test {
namespace {

class MisbehavingVisualisation final : public Visualisation {
 public:
  static PluginDescription describe() {
    PluginDescription description;
    description.label = "misbehaving_visualisation";
    description.summary = "Misbehaves.";
    for (const char* name : {"phase", "deed"}) {
      Parameter parameter;
      parameter.name = name;
      parameter.description = "What it does, and when.";
      description.parameters.push_back(parameter);
    }
    return description;
  }

  void configure(const std::string& id, const Configuration& parameters, const RunContext&) override {
    id_ = id;
    phase_ = parameters.text("phase");
    deed_ = parameters.text("deed");
    tryIn("configure");
  }

  void draw(const Space& space) override {
    constexpr std::uint64_t kTick = 3;
    if (space.tick == kTick) {
      tryIn("draw");
    }
  }

  void finish() override { tryIn("finish"); }

 private:
  void tryIn(const std::string& phase) const {
    if (phase_ == phase) {
      commit(deed_);
    }
  }

  std::string phase_;
  std::string deed_;
};

}  // namespace
}  // namespace swarmanoid::test

REGISTER_VISUALISATION(swarmanoid::test::MisbehavingVisualisation)

// Phase 7: visualisations, recorders and metrics look at the space; is the run finished?
#include "swarmanoid_interface/user_code.hpp"
#include "tick.hpp"

namespace swarmanoid::phases {

bool show(const Space& space, const std::vector<std::shared_ptr<Visualisation>>& visualisations) {
  bool finish_asked = false;
  for (const auto& visualisation : visualisations) {
    callPlugin("visualisation", visualisation->id(), [&] {
      visualisation->draw(space);
      finish_asked = visualisation->terminate() || finish_asked;
    });
  }
  return finish_asked;
}

}  // namespace swarmanoid::phases

// Phase 7: visualisations, recorders and metrics look at the space; is the run finished?
#include "phases.hpp"
#include "swarmanoid_interface/process/user_code.hpp"

namespace swarmanoid::phases {

bool show(const Space& space, const std::vector<Viewer>& viewers) {
  bool finish_asked = false;
  for (const Viewer& viewer : viewers) {
    callPlugin("draw", viewer.part, space.tick, [&] {
      viewer->draw(space);
      finish_asked = viewer->terminate() || finish_asked;
    });
  }
  return finish_asked;
}

}  // namespace swarmanoid::phases

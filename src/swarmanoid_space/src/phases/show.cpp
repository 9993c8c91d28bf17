// Phase 9: observers (displays, recorders, metrics) read the space, and may request the end of the run.
#include "phases.hpp"
#include "swarmanoid_interface/process/user_code.hpp"

namespace swarmanoid::phases {

bool show(const Space& space, const std::vector<ObserverInstance>& observers) {
  bool finish_asked = false;
  for (const ObserverInstance& observer : observers) {
    callPlugin("draw", observer.part, space.tick, [&] {
      observer->draw(space);
      finish_asked = observer->terminate() || finish_asked;
    });
  }
  return finish_asked;
}

}  // namespace swarmanoid::phases

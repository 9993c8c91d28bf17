// Phase 4: every engine moves what it is in charge of, engines beside each other.
#include "../stopwatch.hpp"
#include "swarmanoid_interface/user_code.hpp"
#include "tick.hpp"

namespace swarmanoid::phases {

void move(Space& space, const std::vector<std::shared_ptr<Engine>>& engines, const Workers& workers,
          std::vector<double>& seconds) {
  seconds.resize(engines.size());
  workers.forRanges(engines.size(), 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      callPlugin("engine", engines[i]->id(), [&] { engines[i]->readMirrors(space); });
    }
  });
  workers.forRanges(engines.size(), 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      Stopwatch stopwatch;
      callPlugin("engine", engines[i]->id(), [&] { engines[i]->move(space, space.clocktick); });
      stopwatch.lap(seconds[i]);
    }
  });
}

}  // namespace swarmanoid::phases

// Phase 4: every engine moves its entities; the engines run in parallel.
#include <atomic>
#include <stdexcept>

#include "../assembly/stopwatch.hpp"
#include "phases.hpp"
#include "swarmanoid_interface/process/user_code.hpp"

namespace swarmanoid::phases {
namespace {

bool isFinite(const Pose& pose) { return pose.position.allFinite() && pose.orientation.coeffs().allFinite(); }

/// Checks sums: for numbers of this size a sum is finite if all its terms are. Rows without an entity have the default
/// pose.
bool areAllFinite(const ByRow<Pose>& poses, const Workers& workers) {
  std::atomic<bool> are_finite{true};
  const auto count = static_cast<std::size_t>(poses.end() - poses.begin());
  workers.forRanges(count, kGrainOfPoses, [&](std::size_t first, std::size_t last) {
    Eigen::Array3d positions = Eigen::Array3d::Zero();
    Eigen::Array4d orientations = Eigen::Array4d::Zero();
    for (std::size_t i = first; i < last; ++i) {
      const Pose& pose = poses[rowAt(i)];
      positions += pose.position.array();
      orientations += pose.orientation.coeffs().array();
    }
    if (!positions.allFinite() || !orientations.allFinite()) {
      are_finite = false;
    }
  });
  return are_finite;
}

/// Stops poses that are not finite before they reach grips, the index, sensors and recordings.
void refuseWhatIsNotFinite(const Space& space, const Workers& workers) {
  if (areAllFinite(space.entities.pose, workers)) {
    return;
  }
  for (const Row row : space.entities.order) {
    if (!isFinite(space.entities.pose[row])) {
      const std::string who = space.mover[row] == nullptr ? "nobody" : "engine '" + space.mover[row]->id() + "'";
      throw std::runtime_error(who + " has moved " + space.entities.model[row]->type + " '" + space.entities.name[row] +
                               "' to a pose that is not finite");
    }
  }
}

}  // namespace

void move(const Space& space, const MoveAccess& access, PositionalIndex& index,
          const std::vector<Named<Engine>>& engines, const Workers& workers, bool are_timed,
          std::vector<double>& seconds) {
  index.close();
  seconds.resize(engines.size());
  workers.forEach(engines.size(), [&](std::size_t i) {
    callPlugin("readMirrors", engines[i].part, space.tick, [&] { engines[i]->readMirrors(space); });
  });
  workers.forEach(engines.size(), [&](std::size_t i) {
    Stopwatch stopwatch(are_timed);
    callPlugin("move", engines[i].part, space.tick, [&] { engines[i]->move(space, access, space.clocktick); });
    stopwatch.lap(seconds[i]);
  });
  refuseWhatIsNotFinite(space, workers);
}

}  // namespace swarmanoid::phases

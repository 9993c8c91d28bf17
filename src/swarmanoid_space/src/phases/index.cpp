// Phase 6: the positional index gets the new poses; an event names entities that have left the arena.
#include "phases.hpp"

namespace swarmanoid::phases {

void index(const Space& space, PositionalIndex& index, ByRow<char>& outside, std::vector<Event>& events) {
  constexpr double kEdge = 1e-3;  // m: what rests on the ground may sink in by less
  index.rebuild(space.entities);
  const Eigen::Vector3d& size = space.size;
  const double lowest = space.lowestGround();
  for (const Row row : space.entities.order) {
    const Eigen::Vector3d& p = space.entities.pose[row].position;
    const Eigen::Vector3d least(-kEdge, -kEdge, lowest - kEdge);
    const bool is_outside = !((p.array() >= least.array()).all() && (p.array() <= size.array() + kEdge).all());
    if (is_outside && outside[row] == 0 && space.entities.model[row]->is_movable) {
      events.push_back({Event::Kind::kLeftArena, space.entities.name[row], "", ""});
    }
    outside[row] = is_outside ? 1 : 0;
  }
}

}  // namespace swarmanoid::phases

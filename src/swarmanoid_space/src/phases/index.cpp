// Phase 6: the positional index gets the new poses; an event names entities that have left the arena.
#include "phases.hpp"

namespace swarmanoid::phases {

void index(const Space& space, PositionalIndex& index, std::vector<char>& outside, std::vector<Event>& events) {
  constexpr double kEdge = 1e-3;  // m: what rests on the ground may sink in by less
  index.rebuild(space.entities);
  const Eigen::Vector3d& size = space.size;
  const double lowest = space.lowestGround();
  for (const Row row : space.entities.order) {
    const auto i = static_cast<std::size_t>(row);
    const Eigen::Vector3d& p = space.entities.pose[i].position;
    const Eigen::Vector3d least(-kEdge, -kEdge, lowest - kEdge);
    const bool is_outside = !((p.array() >= least.array()).all() && (p.array() <= size.array() + kEdge).all());
    if (is_outside && outside[i] == 0 && space.entities.model[i]->is_movable) {
      events.push_back({Event::Kind::kLeftArena, space.entities.name[i], "", ""});
    }
    outside[i] = is_outside ? 1 : 0;
  }
}

}  // namespace swarmanoid::phases

// Phase 6: the positional index learns the new poses; who has left the arena is noted.
#include "tick.hpp"

namespace swarmanoid::phases {

void index(Space& space) {
  space.index.rebuild(space.entities);
  const Eigen::Vector3d& size = space.size;
  const double lowest = space.lowestGround();
  for (const Row row : space.entities.order) {
    const auto i = static_cast<std::size_t>(row);
    const Eigen::Vector3d& p = space.entities.pose[i].position;
    const bool is_outside = !(p.x() >= 0.0 && p.x() <= size.x() && p.y() >= 0.0 && p.y() <= size.y() &&
                              p.z() >= lowest && p.z() <= size.z());
    if (is_outside && space.outside[i] == 0 && space.entities.model[i]->is_movable) {
      space.events.push_back({Event::Kind::kLeftArena, space.entities.name[i], "", ""});
    }
    space.outside[i] = is_outside ? 1 : 0;
  }
}

}  // namespace swarmanoid::phases

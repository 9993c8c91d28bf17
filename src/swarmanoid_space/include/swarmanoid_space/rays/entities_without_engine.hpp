/// Entities that no engine holds, such as walls that are in the way of sensors alone: rays are cast against their
/// models. What is near a ray is looked up in a grid, however many walls a maze has.
///
/// Phase   changed between ticks, as entities come, go and are moved; read in all others.
/// Threads const functions may run at once.
#pragma once

#include "swarmanoid_space/index/box_grid.hpp"
#include "swarmanoid_space/rays/obstacles.hpp"
#include "swarmanoid_space/rays/ray.hpp"

namespace swarmanoid {

class EntitiesWithoutEngine {
 public:
  /// @param size of the arena [m] @param corner of it, with its least coordinates [m]
  void configure(const Eigen::Vector3d& size, const Eigen::Vector3d& corner = Eigen::Vector3d::Zero()) {
    grid_.configure(corner.head<2>(), size.head<2>());
  }

  /// Adds an entity, or takes its new pose.
  void place(const Entities& entities, Row row);
  /// Takes the poses of all that are here.
  void refresh(const Entities& entities);
  /// Does nothing if it is not here.
  void remove(Row row);
  void clear() { grid_.clear(); }

  bool has(Row row) const { return grid_.has(static_cast<std::int32_t>(row)); }
  bool isEmpty() const { return grid_.isEmpty(); }

  /// As those of Engine (engine.hpp).
  bool mayHit(const RayBundle& rays) const;
  void findObstacles(const RayBundle& rays, Obstacles& found) const;
  void raycast(const Entities& entities, const RayBundle& rays, Span<RayHit> hits) const;
  void castRayAt(const Entities& entities, Row row, const Segment& segment, RayHit& hit) const;

 private:
  template <class Visit>  // visit(row, bounds) until it returns false
  void visitNear(const RayBundle& rays, Visit visit) const;

  BoxGrid grid_;  // bodies are rows
};

}  // namespace swarmanoid

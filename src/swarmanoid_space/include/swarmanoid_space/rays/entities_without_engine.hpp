/// Entities in no engine, such as walls that only block sensors: rays are cast against their models. A grid limits each
/// look-up to the entities near the ray, for any number of walls.
///
/// Phase   changed between ticks, when entities are added, removed or moved; read in all other phases.
/// Threads const functions may run concurrently.
#pragma once

#include "swarmanoid_space/index/box_grid.hpp"
#include "swarmanoid_space/rays/obstacles.hpp"
#include "swarmanoid_space/rays/ray.hpp"

namespace swarmanoid {

class EntitiesWithoutEngine {
 public:
  /// @param size of the arena [m] @param corner of the arena, with its least coordinates [m]
  void configure(const Eigen::Vector3d& size, const Eigen::Vector3d& corner = Eigen::Vector3d::Zero()) {
    grid_.configure(corner.head<2>(), size.head<2>());
  }

  /// Adds an entity, or updates its pose.
  void place(const Entities& entities, Row row);
  /// Updates the poses of all contained entities.
  void refresh(const Entities& entities);
  /// Does nothing if the entity is not contained.
  void remove(Row row);
  void clear() { grid_.clear(); }

  bool has(Row row) const { return grid_.has(static_cast<std::int32_t>(row)); }
  bool isEmpty() const { return grid_.isEmpty(); }

  /// Same as the functions of RayTarget (ray_target.hpp).
  bool mayHit(const RayBundle& rays) const;
  void findObstacles(const RayBundle& rays, Obstacles& found) const;
  void raycast(const Entities& entities, const RayBundle& rays, Span<RayHit> hits) const;
  void castRayAt(const Entities& entities, Row row, const Segment& segment, RayHit& hit) const;

 private:
  template <class Visit>  // visit(row, bounds) until it returns false
  void visitNear(const RayBundle& rays, Visit visit) const;

  BoxGrid grid_;  // items are rows
};

}  // namespace swarmanoid

#include "swarmanoid_space/rays/entities_without_engine.hpp"

#include "../index/bounds_of.hpp"
#include "swarmanoid_space/rays/solid_ray.hpp"

namespace swarmanoid {
namespace {

Eigen::AlignedBox2d fromAbove(const Eigen::AlignedBox3d& bounds) {
  return {bounds.min().head<2>(), bounds.max().head<2>()};
}

}  // namespace

void EntitiesWithoutEngine::place(const Entities& entities, Row row) {
  grid_.set(static_cast<std::int32_t>(row), fromAbove(boundsOf(*entities.model[row], entities.pose[row])));
}

void EntitiesWithoutEngine::refresh(const Entities& entities) {
  for (const Row row : entities.order) {
    if (has(row)) {
      place(entities, row);
    }
  }
}

void EntitiesWithoutEngine::remove(Row row) {
  if (has(row)) {
    grid_.remove(static_cast<std::int32_t>(row));
  }
}

template <class Visit>
void EntitiesWithoutEngine::visitNear(const RayBundle& rays, Visit visit) const {
  grid_.visitNear(rays.centre.head<2>(), rays.radius, [&](std::int32_t body) {
    const Row row{body};
    return row == rays.ignored || row == rays.also_ignored || visit(row, grid_.bounds(body));
  });
}

bool EntitiesWithoutEngine::mayHit(const RayBundle& rays) const {
  bool may_hit = false;
  visitNear(rays, [&](Row, const Eigen::AlignedBox2d&) {
    may_hit = true;
    return false;
  });
  return may_hit;
}

void EntitiesWithoutEngine::findObstacles(const RayBundle& rays, Obstacles& found) const {
  visitNear(rays, [&](Row row, const Eigen::AlignedBox2d& bounds) {
    found.add(Obstacles::Box{{nullptr, row, Obstacles::kWhole}, bounds.min(), bounds.max()});
    return !found.areAnywhere();
  });
}

void EntitiesWithoutEngine::castRayAt(const Entities& entities, Row row, const Segment& segment, RayHit& hit) const {
  const double fraction = closestHit(segment, *entities.model[row], entities.pose[row]);
  // of two surfaces at the same distance the ray hits the older entity's, in any order of the look-up
  const bool is_older = hit.row != kNoRow && has(hit.row) && entities.number[row] < entities.number[hit.row];
  if (fraction < hit.fraction || (fraction == hit.fraction && is_older)) {
    hit = {fraction, row};
  }
}

void EntitiesWithoutEngine::raycast(const Entities& entities, const RayBundle& rays, Span<RayHit> hits) const {
  visitNear(rays, [&](Row row, const Eigen::AlignedBox2d& bounds) {
    for (std::size_t k = 0; k < rays.segments.size(); ++k) {
      const Segment& segment = rays.segments[k];
      const Eigen::AlignedBox3d around(segment.from.cwiseMin(segment.to), segment.from.cwiseMax(segment.to));
      if (fromAbove(around).intersects(bounds)) {
        castRayAt(entities, row, segment, hits[k]);
      }
    }
    return true;
  });
}

}  // namespace swarmanoid

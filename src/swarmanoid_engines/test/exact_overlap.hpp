/// Depth of overlap of bodies on the ground, by the exact shapes of their models, independently of any engine.
#pragma once

#include <algorithm>
#include <vector>

#include "planar/planar_overlap.hpp"
#include "swarmanoid_space/space.hpp"

namespace swarmanoid {

/// The shapes of an entity at its pose in the plane z = 0, with its joints at their angles.
inline std::vector<planar::PlanarShape> placedShapes(const Space& space, Row row) {
  const planar::Plane plane;
  const EntityModel& entity = *space.entities.model[row];
  const Pose& pose = space.entities.pose[row];
  planar::PlanarModel model;
  planar::projectModel(entity, plane, plane.baseOf(pose.orientation), model, space.joints[row]);
  std::vector<planar::PlanarShape> placed;
  const double heading = plane.headingOf(pose.orientation);
  planar::placeShapes(model, plane.toLocal(pose.position), std::cos(heading), std::sin(heading), placed);
  return placed;
}

/// The depth of the deepest overlap of two entities; 0 if they do not overlap [m].
inline double overlapOf(const Space& space, Row a, Row b) {
  double deepest = 0.0;
  const double height_a = space.entities.pose[a].position.z();
  const double height_b = space.entities.pose[b].position.z();
  for (const planar::PlanarShape& mine : placedShapes(space, a)) {
    for (const planar::PlanarShape& other : placedShapes(space, b)) {
      if (mine.band.overlaps(other.band, height_a, height_b) && planar::overlap(mine, other)) {
        deepest = std::max(deepest, planar::penetration(mine, other).depth);
      }
    }
  }
  return deepest;
}

/// The deepest overlap of any two of these entities, of which at least one is movable [m].
inline double deepestOverlap(const Space& space, const std::vector<Row>& rows) {
  double deepest = 0.0;
  const Entities& entities = space.entities;
  const auto mayOverlap = [&](Row a, Row b) {
    return (entities.pose[a].position - entities.pose[b].position).norm() <
           entities.model[a]->moving_reach + entities.model[b]->moving_reach;
  };
  const auto isMovable = [&](Row row) { return entities.model[row]->is_movable; };
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t k = i + 1; k < rows.size(); ++k) {
      if ((isMovable(rows[i]) || isMovable(rows[k])) && mayOverlap(rows[i], rows[k])) {
        deepest = std::max(deepest, overlapOf(space, rows[i], rows[k]));
      }
    }
  }
  return deepest;
}

}  // namespace swarmanoid

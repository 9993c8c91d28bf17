/// How deep bodies are in each other, by the exact shapes of their models: nothing of Box2D is asked.
#pragma once

#include <algorithm>
#include <vector>

#include "planar/planar_overlap.hpp"
#include "world.hpp"

namespace swarmanoid::dynamics2d {

/// The shapes of an entity where it is in the plane z = 0, its joints where they are.
inline std::vector<planar::PlanarShape> placedShapes(const World& world, Row row) {
  const planar::Plane plane;
  const EntityModel& entity = *world.space.entities.model[row];
  const Pose& pose = world.pose(row);
  planar::PlanarModel model;
  planar::projectModel(entity, plane, plane.baseOf(pose.orientation), model, world.space.joints[row]);
  std::vector<planar::PlanarShape> placed;
  const double heading = plane.headingOf(pose.orientation);
  planar::placeShapes(model, plane.toLocal(pose.position), std::cos(heading), std::sin(heading), placed);
  return placed;
}

/// The depth of the deepest overlap of two entities; 0 if they do not overlap [m].
inline double overlapOf(const World& world, Row a, Row b) {
  double deepest = 0.0;
  const double height_a = world.pose(a).position.z();
  const double height_b = world.pose(b).position.z();
  for (const planar::PlanarShape& mine : placedShapes(world, a)) {
    for (const planar::PlanarShape& other : placedShapes(world, b)) {
      if (mine.band.overlaps(other.band, height_a, height_b) && planar::overlap(mine, other)) {
        deepest = std::max(deepest, planar::penetration(mine, other).depth);
      }
    }
  }
  return deepest;
}

/// The deepest overlap of any two of these entities of which one at least may move [m].
inline double deepestOverlap(const World& world, const std::vector<Row>& rows) {
  double deepest = 0.0;
  const auto isMovable = [&](Row row) { return world.space.entities.model[row]->is_movable; };
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t k = i + 1; k < rows.size(); ++k) {
      if (isMovable(rows[i]) || isMovable(rows[k])) {
        deepest = std::max(deepest, overlapOf(world, rows[i], rows[k]));
      }
    }
  }
  return deepest;
}

}  // namespace swarmanoid::dynamics2d

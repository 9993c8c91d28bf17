#include "planar/body_overlap.hpp"

#include <algorithm>

#include "planar/planar_overlap.hpp"

namespace swarmanoid::planar {

bool modelsOverlap(const PlanarModel& model, const PlacedPose& pose, double along, const Body& other,
                   std::vector<PlanarShape>& scratch) {
  if (!model.band.meets(other.model->band, along, other.along)) {
    return false;
  }
  // in the other's frame only one of the two models has to be placed
  const Eigen::Vector2d way = pose.position - other.pose.position;
  const double cosine = other.pose.cosine;
  const double sine = other.pose.sine;
  placeShapes(model, {cosine * way.x() + sine * way.y(), cosine * way.y() - sine * way.x()},
              pose.cosine * cosine + pose.sine * sine, pose.sine * cosine - pose.cosine * sine, scratch);
  for (std::size_t i = 0; i < model.shapes.size(); ++i) {
    const PlanarShape& mine = scratch[i];
    for (const PlanarShape& its : other.model->shapes) {
      if (mine.band.meets(its.band, along, other.along) && overlap(mine, its)) {
        return true;
      }
    }
  }
  return false;
}

BodyIndex findOverlap(const Bodies& bodies, const EntityModel& model, const Pose& pose, Span<const Row> ignored) {
  const Plane& plane = bodies.plane();
  PlanarModel projected;
  projectModel(model, plane, plane.baseOf(pose.orientation), projected);
  const PlacedPose placed = PlacedPose::at(plane.toLocal(pose.position), plane.headingOf(pose.orientation));
  const double along = plane.along(pose.position);
  std::vector<PlanarShape> scratch;
  BodyIndex found = kNoBody;
  bodies.visitNear(placed.position, projected.radius, [&](BodyIndex index) {
    const Body& body = bodies[index];
    const bool is_older = found == kNoBody || body.number < bodies[found].number;
    const bool is_ignored = std::find(ignored.begin(), ignored.end(), body.row) != ignored.end();
    if (!is_ignored && is_older && modelsOverlap(projected, placed, along, body, scratch)) {
      found = index;
    }
    return true;
  });
  return found;
}

}  // namespace swarmanoid::planar

#include "planar/body_overlap.hpp"

#include <algorithm>

namespace swarmanoid::planar {

namespace {

/// Calls visit(mine, other's) for all pairs of shapes whose heights overlap, until it returns true. Works in the other
/// body's frame, so that only one of the two models has to be placed. @return whether a visit returned true
template <class Visit>
bool visitPairs(const PlanarModel& model, const PlacedPose& pose, double along, const Body& other, Visit visit) {
  if (!model.band.overlaps(other.model->band, along, other.along)) {
    return false;
  }
  thread_local PlanarShape placed;  // thread_local to reuse its memory
  const Eigen::Vector2d position = other.pose.unrotated(pose.position - other.pose.position);
  const double cosine = pose.cosine * other.pose.cosine + pose.sine * other.pose.sine;
  const double sine = pose.sine * other.pose.cosine - pose.cosine * other.pose.sine;
  for (const PlanarShape& mine : model.shapes) {
    placeShape(mine, position, cosine, sine, placed);
    for (const PlanarShape& theirs : other.model->shapes) {
      if (placed.band.overlaps(theirs.band, along, other.along) && visit(placed, theirs)) {
        return true;
      }
    }
  }
  return false;
}

}  // namespace

bool modelsOverlap(const PlanarModel& model, const PlacedPose& pose, double along, const Body& other) {
  return visitPairs(model, pose, along, other,
                    [](const PlanarShape& mine, const PlanarShape& theirs) { return overlap(mine, theirs); });
}

Penetration deepestPenetration(const PlanarModel& model, const PlacedPose& pose, double along, const Body& other) {
  Penetration deepest;
  visitPairs(model, pose, along, other, [&](const PlanarShape& mine, const PlanarShape& theirs) {
    const Penetration found = overlap(mine, theirs) ? penetration(mine, theirs) : Penetration{};
    if (found.depth > deepest.depth) {
      deepest = found;
    }
    return false;
  });
  deepest.normal = other.pose.rotated(deepest.normal);
  return deepest;
}

BodyIndex findOverlap(const Bodies& bodies, const EntityModel& model, const Pose& pose, Span<const Row> ignored) {
  const Plane& plane = bodies.plane();
  const Eigen::Quaterniond base = plane.baseOf(pose.orientation);
  PlanarModel own;
  const PlanarModel* of_last = bodies.projectionOfLast(model, base);
  if (of_last == nullptr) {
    projectModel(model, plane, base, own);
  }
  const PlanarModel& projected = of_last == nullptr ? own : *of_last;
  const PlacedPose placed = PlacedPose::at(plane.toLocal(pose.position), plane.headingOf(pose.orientation));
  const double along = plane.along(pose.position);
  BodyIndex found = kNoBody;
  bodies.visitNear(placed.position, projected.radius, [&](BodyIndex index) {
    const Body& body = bodies[index];
    const bool is_older = found == kNoBody || body.number < bodies[found].number;
    const bool is_ignored = std::find(ignored.begin(), ignored.end(), body.row) != ignored.end();
    if (!is_ignored && is_older && modelsOverlap(projected, placed, along, body)) {
      found = index;
    }
    return true;
  });
  return found;
}

}  // namespace swarmanoid::planar

// Broad phase: pairs of neighbours.
#include <algorithm>

#include "dynamics3d/contacts/touches.hpp"

namespace swarmanoid::dynamics3d {
namespace {

/// Whether a fixed body may touch the box. Tests boxes at their poses, since bounds of oblique walls are too large.
bool mayMeet(const Body& fixed, const Eigen::AlignedBox3d& box) {
  const Eigen::Vector3d centre = box.center();
  const double radius = 0.5 * box.diagonal().norm();
  return std::any_of(fixed.solids.begin(), fixed.solids.end(), [&](const Solid& solid) {
    if (!solid.box.intersects(box) || dGeomGetClass(solid.geom) != dBoxClass) {
      return solid.box.intersects(box);
    }
    dVector3 sides;
    dGeomBoxGetLengths(solid.geom, sides);
    dQuaternion turn;
    dGeomGetQuaternion(solid.geom, turn);
    const Eigen::Vector3d place = toQuaternion(turn).conjugate() * (centre - toVector(dGeomGetPosition(solid.geom)));
    return (place.cwiseAbs() - 0.5 * toVector(sides)).cwiseMax(0.0).squaredNorm() <= radius * radius;
  });
}

/// Whether the other body is fixed and out of the body's reach.
bool passes(const Body& body, const Body& other) {
  return body.is_dynamic && other.rigid == nullptr && !mayMeet(other, body.steadiness.box);
}

}  // namespace

const std::vector<Body*>& Touches::findPairs(std::size_t bodies) {
  if (touches_.capacity() < kMostTouchesOfABody * bodies) {
    touches_.reserve(kMostTouchesOfABody * bodies);
    pairs_.reserve(touches_.capacity());
    reached_.reserve(2 * pairs_.capacity());
  }
  near_.update([](Body* body) {
    if (!body->steadiness.is_left_out) {
      body->steadiness.box = boundsNow(*body);
    }
    return body->steadiness.box;
  });
  pairs_.clear();
  reached_.clear();
  near_.visitPairs([&](Body* a, Body* b) {
    if ((a->is_dynamic || b->is_dynamic) && !areJoined(*a, *b) && !passes(*a, *b) && !passes(*b, *a)) {
      pairs_.emplace_back(std::min(a->rank, b->rank), std::max(a->rank, b->rank));
      for (Body* body : {a, b}) {
        body->steadiness.time = 0.0;  // the other body may support it, and be removed later
        if (body->steadiness.is_left_out) {
          reached_.push_back(body);
        }
      }
    }
  });
  std::sort(pairs_.begin(), pairs_.end());
  return reached_;
}

}  // namespace swarmanoid::dynamics3d

#include "dynamics3d/contacts/ground_contacts.hpp"

#include <algorithm>

namespace swarmanoid::dynamics3d {

SurfaceContacts collideGround(const GroundSurface& ground, const PlacedSolid& solid, double margin) {
  SurfaceContacts contacts;
  const Eigen::AlignedBox3d bounds = solid.bounds();
  if (bounds.min().z() > ground.highestAt(bounds) + margin) {
    return contacts;
  }
  switch (solid.kind) {
    case CollisionShape::Kind::kSphere:
      collideBall(ground, solid, margin, contacts);
      break;
    case CollisionShape::Kind::kBox:
      collideCorners(ground, solid, margin, contacts);
      collideRidges(ground, solid, margin, contacts);
      break;
    case CollisionShape::Kind::kCylinder:
      collideRims(ground, solid, margin, contacts);
      collideRidges(ground, solid, margin, contacts);
      break;
  }
  return contacts;
}

double riseOut(const GroundSurface& ground, const std::vector<CollisionShape>& shapes, const Pose& body) {
  constexpr int kMostSteps = 30;
  constexpr double kOut = 1e-6;          // m
  constexpr double kLeastUpwards = 0.1;  // cosine; cliffs push sideways, so the way up is found in steps
  Pose lifted = body;
  for (int step = 0; step < kMostSteps; ++step) {
    double depth = 0.0;
    for (const CollisionShape& shape : shapes) {
      const PlacedSolid solid(shape, lifted);
      if (!ground.isRoughAt(solid.bounds())) {
        continue;
      }
      for (const SurfaceContact& contact : collideGround(ground, solid, 0.0)) {
        depth = std::max(depth, contact.depth / std::max(contact.normal.z(), kLeastUpwards));
      }
    }
    if (depth < kOut) {
      break;
    }
    lifted.position.z() += depth;
  }
  return lifted.position.z() - body.position.z();
}

}  // namespace swarmanoid::dynamics3d

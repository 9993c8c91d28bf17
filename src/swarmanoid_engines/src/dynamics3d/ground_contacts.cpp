#include "dynamics3d/ground_contacts.hpp"

#include <algorithm>
#include <limits>

namespace swarmanoid::dynamics3d {

void GroundContacts::add(const GroundContact& contact) {
  constexpr double kSame = 1e-6;  // m
  for (std::size_t i = 0; i < count_; ++i) {
    if ((contacts_[i].position - contact.position).squaredNorm() < kSame * kSame &&
        (contacts_[i].normal - contact.normal).squaredNorm() < kSame) {
      return;
    }
  }
  if (count_ < kRoom) {
    contacts_[count_++] = contact;
    return;
  }
  const auto is_shallower = [](const GroundContact& a, const GroundContact& b) { return a.depth < b.depth; };
  GroundContact& shallowest = *std::min_element(contacts_.begin(), contacts_.end(), is_shallower);
  if (shallowest.depth < contact.depth) {
    shallowest = contact;
  }
}

void GroundContacts::keepSpread(std::size_t most) {
  if (count_ <= most) {
    return;
  }
  const auto is_shallower = [](const GroundContact& a, const GroundContact& b) { return a.depth < b.depth; };
  std::swap(contacts_[0], *std::max_element(contacts_.begin(), contacts_.begin() + count_, is_shallower));
  for (std::size_t kept = 1; kept < most; ++kept) {
    const auto distance = [&](const GroundContact& contact) {
      double nearest = std::numeric_limits<double>::infinity();
      for (std::size_t i = 0; i < kept; ++i) {
        nearest = std::min(nearest, (contacts_[i].position - contact.position).squaredNorm());
      }
      return nearest;
    };
    const auto is_nearer = [&](const GroundContact& a, const GroundContact& b) { return distance(a) < distance(b); };
    std::swap(contacts_[kept], *std::max_element(contacts_.begin() + kept, contacts_.begin() + count_, is_nearer));
  }
  count_ = most;
}

GroundContacts meetGround(const GroundSurface& ground, const PlacedSolid& solid, double margin) {
  GroundContacts contacts;
  const Eigen::AlignedBox3d bounds = solid.bounds();
  if (bounds.min().z() > ground.highestAt(bounds) + margin) {
    return contacts;
  }
  switch (solid.kind) {
    case CollisionShape::Kind::kSphere:
      meetBall(ground, solid, margin, contacts);
      break;
    case CollisionShape::Kind::kBox:
      meetCorners(ground, solid, margin, contacts);
      meetRidges(ground, solid, margin, contacts);
      break;
    case CollisionShape::Kind::kCylinder:
      meetRims(ground, solid, margin, contacts);
      meetRidges(ground, solid, margin, contacts);
      break;
  }
  return contacts;
}

double riseOut(const GroundSurface& ground, const std::vector<CollisionShape>& shapes, const Pose& body) {
  constexpr int kMostSteps = 30;
  constexpr double kOut = 1e-6;          // m
  constexpr double kLeastUpwards = 0.1;  // cosine; cliffs push aside, so the way up is found in steps
  Pose lifted = body;
  for (int step = 0; step < kMostSteps; ++step) {
    double depth = 0.0;
    for (const CollisionShape& shape : shapes) {
      const PlacedSolid solid(shape, lifted);
      if (!ground.isRoughAt(solid.bounds())) {
        continue;
      }
      for (const GroundContact& contact : meetGround(ground, solid, 0.0)) {
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

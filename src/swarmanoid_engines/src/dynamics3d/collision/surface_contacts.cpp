#include "dynamics3d/collision/surface_contacts.hpp"

#include <algorithm>
#include <limits>

namespace swarmanoid::dynamics3d {

dContactGeom geometryOf(const SurfaceContact& contact, dGeomID solid, dGeomID surface) {
  dContactGeom geometry = {};
  geometry.depth = contact.depth;
  Eigen::Map<Eigen::Vector3d>(geometry.normal) = contact.normal;
  Eigen::Map<Eigen::Vector3d>(geometry.pos) = contact.position;
  geometry.g1 = solid;
  geometry.g2 = surface;
  return geometry;
}

void SurfaceContacts::add(const SurfaceContact& contact) {
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
  const auto is_shallower = [](const SurfaceContact& a, const SurfaceContact& b) { return a.depth < b.depth; };
  SurfaceContact& shallowest = *std::min_element(contacts_.begin(), contacts_.end(), is_shallower);
  if (shallowest.depth < contact.depth) {
    shallowest = contact;
  }
}

void SurfaceContacts::keepSpread(std::size_t most) {
  if (count_ <= most) {
    return;
  }
  const auto is_shallower = [](const SurfaceContact& a, const SurfaceContact& b) { return a.depth < b.depth; };
  std::swap(contacts_[0], *std::max_element(contacts_.begin(), contacts_.begin() + count_, is_shallower));
  for (std::size_t kept = 1; kept < most; ++kept) {
    const auto distance = [&](const SurfaceContact& contact) {
      double nearest = std::numeric_limits<double>::infinity();
      for (std::size_t i = 0; i < kept; ++i) {
        nearest = std::min(nearest, (contacts_[i].position - contact.position).squaredNorm());
      }
      return nearest;
    };
    const auto is_nearer = [&](const SurfaceContact& a, const SurfaceContact& b) { return distance(a) < distance(b); };
    std::swap(contacts_[kept], *std::max_element(contacts_.begin() + kept, contacts_.begin() + count_, is_nearer));
  }
  count_ = most;
}

}  // namespace swarmanoid::dynamics3d

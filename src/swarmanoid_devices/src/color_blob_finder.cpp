#include "color_blob_finder.hpp"

#include <algorithm>
#include <cmath>

namespace swarmanoid::devices {
namespace {

// A surface this near to the point looked at is the point's own surface, not an obstacle (fraction of the way).
constexpr double kOwnSurface = 1e-6;

class Finder {
 public:
  Finder(const Space& space, const BlobView& view, ColorBlob* blobs, std::size_t capacity)
      : space_(space), view_(view), blobs_(blobs), capacity_(capacity) {}

  void lookAtEntity(Row row) {
    const auto i = static_cast<std::size_t>(row);
    const Entities& entities = space_.entities;
    const std::vector<Eigen::Vector3d>& points = entities.model[i]->led_positions;
    const Color* leds = space_.ledsOf(row);
    for (std::size_t k = 0; k < points.size(); ++k) {
      // robots shine with their LEDs, other things have a colour of their own
      const Color color = entities.model[i]->is_robot ? leds[k] : entities.color[i];
      if (color.isLit()) {
        look(entities.pose[i].position + entities.pose[i].orientation * points[k], color, row);
      }
    }
  }

  /// @return whether the point is in sight
  bool look(const Eigen::Vector3d& point, Color color, Row owner) {
    if (!view_.inView(point)) {
      return false;
    }
    const RayHit hit = space_.castRay({view_.position, point}, view_.self, owner);
    if (hit.fraction < 1.0 - kOwnSurface) {
      return false;
    }
    if (count_ < capacity_) {
      const Eigen::Vector2d offset = (point - view_.position).head<2>();
      const float bearing = toBearing(std::atan2(offset.y(), offset.x()) - view_.heading);
      blobs_[count_] = {color, bearing, static_cast<float>(offset.norm())};
    }
    ++count_;
    return true;
  }

  std::size_t count() const { return count_; }

 private:
  const Space& space_;
  const BlobView& view_;
  ColorBlob* blobs_;
  std::size_t capacity_;
  std::size_t count_ = 0;
};

}  // namespace

float toBearing(double angle) {
  const auto bearing = static_cast<float>(std::remainder(angle, 2.0 * M_PI));
  constexpr auto kBehind = static_cast<float>(M_PI);
  return bearing <= -kBehind ? kBehind : bearing;
}

bool BlobView::inView(const Eigen::Vector3d& point) const {
  const double horizontal = (point - position).head<2>().norm();
  return horizontal <= range && (slope == 0.0 || horizontal <= slope * (position.z() - point.z()));
}

std::size_t findBlobs(const Space& space, const BlobView& view, ColorBlob* blobs, std::size_t capacity) {
  Finder finder(space, view, blobs, capacity);
  // kept between calls so that a steady state allocates nothing
  thread_local std::vector<Row> near;
  near.clear();
  // entities are at any height within the arena, so the sphere must hold the whole cylinder of view
  const double lowest = space.lowestGround();
  const double half_height = 0.5 * (space.size.z() - lowest);
  const Eigen::Vector3d centre(view.position.x(), view.position.y(), lowest + half_height);
  space.index.collect(centre, std::hypot(view.range, half_height), near);
  const Entities& entities = space.entities;
  std::sort(near.begin(), near.end(), [&](Row a, Row b) {
    return entities.number[static_cast<std::size_t>(a)] < entities.number[static_cast<std::size_t>(b)];
  });
  for (const Row row : near) {
    if (row != view.self) {
      finder.lookAtEntity(row);
    }
  }
  for (const LaserSpot& spot : space.laser_spots) {
    finder.look(spot.position, spot.color, kNoRow);
  }
  if (view.sees_floor) {
    for (const FloorPatch& patch : space.floor_patches) {
      // where its middle is hidden or too far the nearest part stands for the patch
      if (!finder.look(patch.position, patch.color, kNoRow)) {
        finder.look(patch.nearestPoint(view.position), patch.color, kNoRow);
      }
    }
  }
  return finder.count();
}

}  // namespace swarmanoid::devices

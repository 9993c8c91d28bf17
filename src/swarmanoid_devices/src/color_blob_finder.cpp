#include "color_blob_finder.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "keep_nearest.hpp"
#include "swarmanoid_interface/angle.hpp"
#include "swarmanoid_space/rays/solid_ray.hpp"

namespace swarmanoid::devices {
namespace {

/// A blob, and its rank in the order defined by ColorBlobs.
struct Found {
  ColorBlob blob;
  std::size_t place = 0;
};

class Finder {
 public:
  Finder(const Space& space, const BlobView& view, std::vector<Found>& found)
      : space_(space), view_(view), found_(found) {}

  void lookAtEntity(Row row) {
    const EntityModel& model = *space_.entities.model[row];
    const Pose& pose = space_.entities.pose[row];
    std::array<Eigen::Vector3d, LedSet{}.size()> points;
    LedSet lit;
    const std::size_t count = std::min(model.led_positions.size(), lit.size());
    const Span<const Color> leds = space_.leds[row];
    const Color own = space_.ownColor(row);
    const auto color_of = [&](std::size_t led) { return model.is_robot ? leds[led] : own; };
    for (std::size_t k = 0; k < count; ++k) {
      if (color_of(k).isLit()) {
        points[k] = pose.toWorld(model.led_positions[k]);
        lit[k] = view_.inView(points[k]);
      }
    }
    if (lit.none()) {
      return;
    }
    const Eigen::Vector3d eye = pose.orientation.conjugate() * (view_.position - pose.position);
    const LedSet seen = lit & ~hiddenLeds(model, space_.joints[row], eye, lit);
    for (std::size_t k = 0; k < count; ++k) {
      if (seen[k]) {
        see(points[k], color_of(k), row);
      }
    }
  }

  /// @return whether the point is in sight
  bool look(const Eigen::Vector3d& point, Color color, Row owner) {
    return view_.inView(point) && see(point, color, owner);
  }

 private:
  /// @pre the point is in view @return whether nothing hides it
  bool see(const Eigen::Vector3d& point, Color color, Row owner) {
    const RayHit hit = space_.castRay({view_.position, point}, view_.self, owner);
    if (hit.fraction < 1.0 - kOwnSurface) {
      return false;
    }
    const Eigen::Vector2d offset = (point - view_.position).head<2>();
    const float bearing = toBearing(std::atan2(offset.y(), offset.x()) - view_.heading);
    found_.push_back({{color, bearing, static_cast<float>(offset.norm())}, found_.size()});
    return true;
  }

  const Space& space_;
  const BlobView& view_;
  std::vector<Found>& found_;
};

}  // namespace

float toBearing(double angle) {
  const auto bearing = static_cast<float>(wrapAngle(angle));
  constexpr auto kBehind = static_cast<float>(M_PI);
  return bearing <= -kBehind ? kBehind : bearing;
}

bool BlobView::inView(const Eigen::Vector3d& point) const {
  const double horizontal = (point - position).head<2>().norm();
  return horizontal <= range && (slope == 0.0 || horizontal <= slope * (position.z() - point.z()));
}

FoundBlobs findBlobs(const Space& space, const BlobView& view, ColorBlob* blobs, std::size_t capacity) {
  // kept between calls so that a steady state allocates nothing
  thread_local std::vector<Row> near;
  thread_local std::vector<Found> found;
  near.clear();
  found.clear();
  found.reserve(capacity);
  Finder finder(space, view, found);
  // entities may be at any height within the arena, so the sphere must contain the whole cylinder of view
  const double lowest = space.lowestGround();
  const double half_height = 0.5 * (space.size.z() - lowest);
  const Eigen::Vector3d centre(view.position.x(), view.position.y(), lowest + half_height);
  space.index.collect(centre, std::hypot(view.range, half_height), near);
  const Entities& entities = space.entities;
  std::sort(near.begin(), near.end(), [&](Row a, Row b) { return entities.number[a] < entities.number[b]; });
  for (const Row row : near) {
    if (row != view.self) {
      finder.lookAtEntity(row);
    }
  }
  for (const LaserSpot& spot : space.laser_spots) {
    finder.look(spot.position, spot.color, kNoRow);
  }
  if (view.sees_floor) {
    for (const FloorPatch& patch : space.floor.patches) {
      // if the middle of the patch is hidden or too far, its nearest part is used instead
      if (!finder.look(patch.position, patch.color, kNoRow)) {
        finder.look(patch.nearestPoint(view.position), patch.color, kNoRow);
      }
    }
  }
  FoundBlobs result;
  result.overflowed = keepNearest(found, capacity, [](const Found& each) { return each.blob.distance; });
  result.count = found.size();
  std::transform(found.begin(), found.end(), blobs, [](const Found& each) { return each.blob; });
  return result;
}

}  // namespace swarmanoid::devices

#include "color_blob_finder.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "light_cone.hpp"
#include "swarmanoid_interface/angle.hpp"
#include "swarmanoid_interface/arctangent.hpp"
#include "transmitters.hpp"

namespace swarmanoid::devices {
namespace {

class Finder {
 public:
  Finder(const Space& space, const BlobView& view, NearObstacles& obstacles, LedShades& shades,
         std::vector<Sighting>& found)
      : space_(space), view_(view), obstacles_(obstacles), shades_(shades), found_(found) {}

  void lookAtEntity(Row row) {
    const EntityModel& model = *space_.entities.model[row];
    if (model.led_positions.empty()) {
      return;
    }
    LedSet lit = litOf(model, row);
    if (lit.none()) {
      return;
    }
    const Pose& pose = space_.entities.pose[row];
    const LedPoints points(model, pose);
    lit = view_.inView(points, lit);
    if (lit.none() || !lightConeOf(space_, row).holds(view_.eye.position - pose.position)) {
      return;
    }
    const Eigen::Vector3d eye = pose.orientation.conjugate() * (view_.eye.position - pose.position);
    shades_.begin(model, space_.joints[row]);
    LedSet seen = lit & ~shades_.hidden(eye, lit);
    seen &= ~obstacles_.hidden(points, seen, row);
    // entities without shapes are lamps
    const double radius = model.is_robot || model.shapes.empty() ? ColorBlob::kPointRadius : model.horizontal_radius;
    visitLeds(seen, [&](std::size_t k) { note(points[k], colorOf(model, row, k), radius); });
  }

  /// @return whether the point is visible
  bool look(const Eigen::Vector3d& point, Color color, double radius) {
    if (!view_.inView(point) || obstacles_.hides(point, kNoRow)) {
      return false;
    }
    note(point, color, radius);
    return true;
  }

 private:
  Color colorOf(const EntityModel& model, Row row, std::size_t led) const {
    return model.is_robot ? space_.leds[row][led] : space_.ownColor(row);
  }

  LedSet litOf(const EntityModel& model, Row row) const {
    const std::size_t count = std::min(model.led_positions.size(), EntityModel::kMaxLeds);
    if (!model.is_robot) {
      return space_.ownColor(row).isLit() ? LedSet((~std::uint64_t{0}) >> (64 - count)) : LedSet();
    }
    const Span<const Color> leds = space_.leds[row];
    std::uint64_t lit = 0;
    for (std::size_t k = 0; k < count; ++k) {
      lit |= static_cast<std::uint64_t>(leds[k].isLit()) << k;
    }
    return LedSet(lit);
  }

  void note(const Eigen::Vector3d& point, Color color, double radius) {
    found_.push_back(sightingOf(view_.eye, point, color, radius, found_.size()));
  }

  const Space& space_;
  const BlobView& view_;
  NearObstacles& obstacles_;
  LedShades& shades_;
  std::vector<Sighting>& found_;
};

/// Half the width; for a rectangle half the longer side [m].
double radiusOf(const FloorPatch& patch) { return patch.radius > 0.0 ? patch.radius : 0.5 * patch.size.maxCoeff(); }

}  // namespace

float toBearing(double angle) {
  const auto bearing = static_cast<float>(wrapAngle(angle));
  constexpr auto kBehind = static_cast<float>(M_PI);
  return bearing <= -kBehind ? kBehind : bearing;
}

bool BlobView::inView(const Eigen::Vector3d& point) const {
  const Eigen::Vector3d way = point - eye.position;
  const double horizontal = way.head<2>().norm();
  return horizontal <= range && field->contains(eye, way, horizontal);
}

LedSet BlobView::inView(const LedPoints& points, const LedSet& asked) const {
  LedPoints::Column horizontal;
  for (std::size_t k = 0; k < points.count; ++k) {  // without branches, so that compilers vectorise it
    const double x = points.x[k] - eye.position.x();
    const double y = points.y[k] - eye.position.y();
    horizontal[k] = std::sqrt(x * x + y * y);
  }
  LedSet found;
  visitLeds(asked, [&](std::size_t k) { found[k] = horizontal[k] <= range; });
  if (!field->isAll()) {
    visitLeds(found, [&](std::size_t k) { found[k] = field->contains(eye, points[k] - eye.position, horizontal[k]); });
  }
  return found;
}

Sighting sightingOf(const Eye& eye, const Eigen::Vector3d& point, Color color, double radius, std::size_t place) {
  const Eigen::Vector3d way = point - eye.position;
  return {color, way, static_cast<float>(way.head<2>().norm()), radius, place};
}

void toBlobs(const std::vector<Sighting>& sightings, const Eye& eye, bool knows_distance, Span<ColorBlob> blobs) {
  constexpr std::size_t kSome = 32;
  constexpr auto kBehind = static_cast<float>(M_PI);
  // by column, in single precision: components forward, left and up, and horizontal distance
  std::array<float, kSome> ahead;
  std::array<float, kSome> left;
  std::array<float, kSome> up;
  std::array<float, kSome> distance;
  std::array<float, kSome> radius;
  for (std::size_t first = 0; first < sightings.size(); first += kSome) {
    const std::size_t count = std::min(kSome, sightings.size() - first);
    for (std::size_t i = 0; i < count; ++i) {
      const Sighting& sighting = sightings[first + i];
      const Eigen::Vector3d& way = sighting.way;
      ahead[i] = static_cast<float>(eye.forward.x() * way.x() + eye.forward.y() * way.y());
      left[i] = static_cast<float>(eye.forward.x() * way.y() - eye.forward.y() * way.x());
      up[i] = static_cast<float>(way.z());
      distance[i] = sighting.distance;
      radius[i] = static_cast<float>(sighting.radius);
    }
    // a separate loop without calls or branches, so that compilers vectorise it
    std::array<float, kSome> bearing;
    std::array<float, kSome> elevation;
    std::array<float, kSome> size;
    for (std::size_t i = 0; i < count; ++i) {
      const float angle = arctangent(left[i], ahead[i]);
      bearing[i] = angle <= -kBehind ? kBehind : angle;
      elevation[i] = arctangent(up[i], distance[i]);
      size[i] = ColorBlob::sizeOf(radius[i], std::sqrt(distance[i] * distance[i] + up[i] * up[i]));
    }
    for (std::size_t i = 0; i < count; ++i) {
      const float known = knows_distance ? distance[i] : std::numeric_limits<float>::quiet_NaN();
      blobs[first + i] = {sightings[first + i].color, bearing[i], known, elevation[i], size[i]};
    }
  }
}

void lookAround(const Space& space, const BlobView& view, std::vector<Sighting>& found) {
  // kept between calls so that a steady state allocates nothing
  thread_local std::vector<Row> near;
  thread_local NearObstacles obstacles;
  thread_local LedShades shades;
  near.clear();
  found.clear();
  const Eigen::Vector3d& eye = view.eye.position;
  // entities with LEDs in range, whose LEDs may stand out of their solids, and possible obstacles
  space.index.collectUpright(eye.head<2>(), view.range + std::max(kMostOutside, space.index.prismMargin()), near);
  const Entities& entities = space.entities;
  std::sort(near.begin(), near.end(), [&](Row a, Row b) { return entities.number[a] < entities.number[b]; });
  // spots on the ground may be below it by rounding
  constexpr double kBelow = 1e-3;  // m
  obstacles.begin(space, view.self, eye, near, space.lowestGround() - kBelow, space.farCorner().z());
  Finder finder(space, view, obstacles, shades, found);
  for (const Row row : near) {
    if (row != view.self) {
      finder.lookAtEntity(row);
    }
  }
  for (const LaserSpot& spot : space.laser_spots) {
    finder.look(spot.position, spot.color, ColorBlob::kPointRadius);
  }
  if (view.sees_floor) {
    for (const FloorPatch& patch : space.floor.patches) {
      // if the middle of the patch is hidden or too far, its nearest part is used instead
      if (!finder.look(patch.position, patch.color, radiusOf(patch))) {
        finder.look(patch.nearestPoint(eye), patch.color, radiusOf(patch));
      }
    }
  }
}

}  // namespace swarmanoid::devices

// Rays against the bodies, extruded to their heights.
#include <algorithm>
#include <array>

#include "kinematics2d/kinematics2d.hpp"
#include "planar/planar_ray.hpp"

namespace swarmanoid::kinematics2d {
namespace {

using planar::PlanarRay;

/// Some rays of a bundle in the plane's frame, column by column so that all are compared with a body at once.
class PlanarRays {
 public:
  static constexpr std::size_t kMost = 32;

  PlanarRays(const planar::Plane& plane, Span<const Segment> segments) : count_(segments.size()) {
    for (std::size_t k = 0; k < count_; ++k) {
      const Eigen::Vector2d from = plane.toLocal(segments[k].from);
      const Eigen::Vector2d step = plane.toLocal(segments[k].to) - from;
      from_x_[k] = from.x();
      from_y_[k] = from.y();
      step_x_[k] = step.x();
      step_y_[k] = step.y();
      length_squared_[k] = step.squaredNorm();
      height_[k] = plane.along(segments[k].from);
      climb_[k] = plane.along(segments[k].to) - height_[k];
    }
  }

  std::size_t count() const { return count_; }

  /// Finds the rays that come near a point, seen from above. @return how many; they stand in `near()`
  std::size_t findNear(const Eigen::Vector2d& point, double radius) {
    // without branches and divisions, so that the compiler works on several rays at once: all is scaled by the length
    const double x = point.x();
    const double y = point.y();
    const double radius_squared = radius * radius;
    for (std::size_t k = 0; k < count_; ++k) {
      const double way_x = x - from_x_[k];
      const double way_y = y - from_y_[k];
      const double length_squared = length_squared_[k];
      const double progress = std::min(std::max(way_x * step_x_[k] + way_y * step_y_[k], 0.0), length_squared);
      const bool is_point = length_squared == 0.0;
      const double scale = is_point ? 1.0 : length_squared;
      const double off_x = way_x * scale - progress * step_x_[k];
      const double off_y = way_y * scale - progress * step_y_[k];
      excess_[k] = off_x * off_x + off_y * off_y - radius_squared * scale * scale;
    }
    std::size_t found = 0;
    for (std::size_t k = 0; k < count_; ++k) {
      near_[found] = static_cast<unsigned char>(k);
      found += excess_[k] <= 0.0 ? 1 : 0;
    }
    return found;
  }
  const unsigned char* near() const { return near_.data(); }

  /// Ray k in the frame of a body.
  PlanarRay relativeTo(const PlacedPose& pose, std::size_t k) const {
    const double way_x = from_x_[k] - pose.position.x();
    const double way_y = from_y_[k] - pose.position.y();
    PlanarRay ray;
    ray.from = {pose.cosine * way_x + pose.sine * way_y, pose.cosine * way_y - pose.sine * way_x};
    ray.step = {pose.cosine * step_x_[k] + pose.sine * step_y_[k], pose.cosine * step_y_[k] - pose.sine * step_x_[k]};
    ray.height = height_[k];
    ray.climb = climb_[k];
    return ray;
  }

 private:
  using Column = std::array<double, kMost>;
  std::size_t count_;
  Column from_x_;
  Column from_y_;
  Column step_x_;
  Column step_y_;
  Column length_squared_;
  Column height_;
  Column climb_;
  Column excess_;
  std::array<unsigned char, kMost> near_;
};

}  // namespace

void Kinematics2d::castRays(const RayBundle& rays, Span<RayHit> hits) const {
  if (areAllOutOfReach(rays)) {
    return;
  }
  const planar::Plane& plane = bodies_.plane();
  const Eigen::Vector2d centre = plane.toLocal(rays.centre);
  for (std::size_t first = 0; first < rays.segments.size(); first += PlanarRays::kMost) {
    const std::size_t count = std::min(PlanarRays::kMost, rays.segments.size() - first);
    std::optional<PlanarRays> planar_rays;  // made when the first body is near: often none is
    bodies_.visitNear(centre, rays.radius, [&](BodyIndex index) {
      const Body& body = bodies_[index];
      if (body.row == rays.ignored || body.row == rays.also_ignored || body.is_seen_elsewhere) {
        return true;
      }
      if (!planar_rays) {
        planar_rays.emplace(plane, rays.segments.subspan(first, count));
      }
      const std::size_t near = planar_rays->findNear(body.pose.position, body.model->radius);
      for (std::size_t i = 0; i < near; ++i) {
        const std::size_t k = planar_rays->near()[i];
        meetBody(planar_rays->relativeTo(body.pose, k), body, hits[first + k]);
      }
      return true;
    });
  }
}

bool Kinematics2d::areAllOutOfReach(const RayBundle& rays) const {
  // a robot that casts rays knows from moving how far away everybody is
  const BodyIndex caster = rays.ignored == kNoRow || is_somebody_new_ ? kNoBody : bodies_.find(rays.ignored);
  if (caster == kNoBody) {
    return false;
  }
  const Body& body = bodies_[caster];
  const double room = body.model->radius + 2.0 * (body.clearance.free_until - travelled_) - rays.radius;
  const Eigen::Vector2d centre = bodies_.plane().toLocal(rays.centre);
  return body.clearance.at_all_heights && room > 0.0 && (centre - body.pose.position).squaredNorm() < room * room;
}

void Kinematics2d::meetBody(const PlanarRay& ray, const Body& body, RayHit& hit) const {
  for (const PlanarShape& shape : body.model->shapes) {
    const double fraction = planar::meeting(ray, shape, body.along);
    if (fraction > hit.fraction) {
      continue;
    }
    // between surfaces at the same distance the older entity is met, whatever the order of the look-up
    const BodyIndex rival = hit.row == kNoRow ? kNoBody : bodies_.find(hit.row);
    if (fraction < hit.fraction || (rival != kNoBody && body.number < bodies_[rival].number)) {
      hit = {fraction, body.row};
    }
  }
}

}  // namespace swarmanoid::kinematics2d

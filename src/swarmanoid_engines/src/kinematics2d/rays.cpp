// Rays against the bodies, extruded to their heights.
#include "kinematics2d/kinematics2d.hpp"
#include "planar/planar_ray.hpp"

namespace swarmanoid::kinematics2d {

void Kinematics2d::castRays(const RayBundle& rays, Span<RayHit> hits) const {
  const planar::Plane& plane = bodies_.plane();
  bodies_.visitNear(plane.toLocal(rays.centre), rays.radius, [&](BodyIndex index) {
    const Body& body = bodies_[index];
    if (body.row == rays.ignored || body.row == rays.also_ignored) {
      return true;
    }
    const std::vector<PlanarShape>& shapes = bodies_.shapes(index);
    for (std::size_t k = 0; k < rays.segments.size(); ++k) {
      const Segment& segment = rays.segments[k];
      planar::PlanarRay ray;
      ray.from = plane.toLocal(segment.from);
      ray.step = plane.toLocal(segment.to) - ray.from;
      if (!body.is_large && !planar::passesNear(ray, body.pose.position, body.model->radius)) {
        continue;
      }
      ray.height = plane.along(segment.from);
      ray.climb = plane.along(segment.to) - ray.height;
      for (const PlanarShape& shape : shapes) {
        const double fraction = planar::meeting(ray, shape, body.along);
        // between surfaces at the same distance the older entity is met, whatever the order of the look-up
        const BodyIndex rival = hits[k].row == kNoRow ? kNoBody : bodies_.find(hits[k].row);
        if (fraction < hits[k].fraction ||
            (fraction == hits[k].fraction && rival != kNoBody && body.number < bodies_[rival].number)) {
          hits[k] = {fraction, body.row};
        }
      }
    }
    return true;
  });
}

}  // namespace swarmanoid::kinematics2d

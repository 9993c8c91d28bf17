/// LEDs in sight of an omnidirectional camera by brute force, one ray to each LED. The reference in tests of cameras.
#pragma once

#include <Eigen/Geometry>
#include <tuple>
#include <vector>

#include "swarmanoid_space/rays/led_shades.hpp"
#include "swarmanoid_space/space.hpp"

namespace swarmanoid {

/// Colour and distance [m].
using SeenLed = std::tuple<int, int, int, float>;

/// Returns the lit LEDs, lamps and preys in sight, by entity number. @param eye in W [m] @param range horizontal [m]
inline std::vector<SeenLed> ledsByPlainRays(const Space& space, Row self, const Eigen::Vector3d& eye, double range) {
  constexpr double kOwnSurface = 1e-6;
  std::vector<SeenLed> seen;
  for (const Row row : space.entities.order) {
    const EntityModel& model = *space.entities.model[row];
    const Pose& pose = space.entities.pose[row];
    LedShades shades;
    shades.begin(model, space.joints[row]);
    for (std::size_t k = 0; row != self && k < model.led_positions.size(); ++k) {
      const Color color = model.is_robot ? space.leds[row][k] : space.ownColor(row);
      const Eigen::Vector3d point = pose.toWorld(model.led_positions[k]);
      const Eigen::Vector3d in_body = pose.orientation.conjugate() * (eye - pose.position);
      LedSet asked;
      asked[k] = true;
      const double distance = (point - eye).head<2>().norm();
      if (color.isLit() && distance <= range && shades.hidden(in_body, asked).none() &&
          space.castRay({eye, point}, self, row).fraction >= 1.0 - kOwnSurface) {
        seen.emplace_back(color.red, color.green, color.blue, static_cast<float>(distance));
      }
    }
  }
  return seen;
}

/// The same list from a camera's readings.
template <class Camera>
std::vector<SeenLed> ledsOf(const Camera& camera) {
  std::vector<SeenLed> seen;
  for (const auto& blob : camera.blobs) {
    seen.emplace_back(blob.color.red, blob.color.green, blob.color.blue, blob.distance);
  }
  return seen;
}

}  // namespace swarmanoid

#include "swarmanoid_rendering/camera.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace swarmanoid {

using Eigen::Vector3d;

CameraAxes axesOf(const Camera& camera) {
  const double level = std::cos(camera.pitch);
  const Vector3d forward(level * std::cos(camera.heading), level * std::sin(camera.heading), std::sin(camera.pitch));
  const Vector3d right(std::sin(camera.heading), -std::cos(camera.heading), 0.0);
  const Eigen::AngleAxisd roll(camera.roll, forward);
  return {forward, roll * right, roll * right.cross(forward)};
}

Camera overview(const Eigen::AlignedBox3d& seen, double field_of_view, double aspect) {
  constexpr double kPitch = -0.85;  // as rviz's initial view
  constexpr double kHeadingNorth = 0.5 * M_PI;
  constexpr double kMargin = 1.04;  // for the walls around the arena
  Camera camera;
  camera.heading = kHeadingNorth;
  camera.pitch = kPitch;
  camera.field_of_view = field_of_view;
  const CameraAxes axes = axesOf(camera);
  const Vector3d size = seen.sizes();
  const double across = std::tan(0.5 * field_of_view) / kMargin;
  double distance = 0.0;  // from the centre; the outermost of the eight corners lies on the border
  for (int corner = 0; corner < 8; ++corner) {
    const Vector3d side((corner & 1) != 0 ? 0.5 : -0.5, (corner & 2) != 0 ? 0.5 : -0.5, (corner & 4) != 0 ? 0.5 : -0.5);
    const Vector3d from_middle = side.cwiseProduct(size);
    const double beside =
        std::max(std::abs(axes.right.dot(from_middle)), aspect * std::abs(axes.up.dot(from_middle))) / across;
    distance = std::max(distance, beside - axes.forward.dot(from_middle));
  }
  camera.position = seen.center() - distance * axes.forward;
  return camera;
}

}  // namespace swarmanoid

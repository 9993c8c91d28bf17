/// Pose and field of view of a camera.
///
/// Frame   positions are in the world frame [m]. A camera whose angles are zero looks along x, with z up.
/// Source  thesis 4.2, camera_view_XYZ_0 and camera_view_HPR_0.
#pragma once

#include <Eigen/Geometry>

namespace swarmanoid {

struct Camera {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  double heading = 0.0;        ///< to the left, about z [rad]
  double pitch = 0.0;          ///< upwards [rad]; the thesis's sign, not that of REP-103
  double roll = 0.0;           ///< about the viewing direction, right-handed: the left side rises [rad]
  double field_of_view = 1.0;  ///< from the left to the right border of the picture [rad], below pi
};

/// Unit axes of a camera in W.
struct CameraAxes {
  Eigen::Vector3d forward;
  Eigen::Vector3d right;
  Eigen::Vector3d up;
};
CameraAxes axesOf(const Camera& camera);

/// A camera that looks north and down at a box. The box fills the picture except for a border of 4 %.
/// @param seen the box, in W [m] @param aspect width of the picture by its height
Camera overview(const Eigen::AlignedBox3d& seen, double field_of_view, double aspect);

}  // namespace swarmanoid

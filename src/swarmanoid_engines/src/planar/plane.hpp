/// The plane of a two-dimensional engine (thesis 3.5.1, figure 3.8), and its local frame.
///
/// The plane is perpendicular to an axis of W, at a signed distance from the origin. Local coordinates (u, v) and the
/// normal n are right-handed: z gives (x, y), x gives (y, z), y gives (z, x). An orientation is split into the heading,
/// a rotation about the normal, and the base, which motion in the plane does not change.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <string>

#include "swarmanoid_space/state/entities.hpp"

namespace swarmanoid::planar {

/// Position and heading in the plane [m, rad].
struct PlanarPose {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();
  double heading = 0.0;
};

inline double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

class Plane {
 public:
  Plane() = default;
  /// @param axis 'x', 'y' or 'z'; @param distance from the origin [m]
  Plane(char axis, double distance)
      : normal_(axis - 'x'), u_((normal_ + 1) % 3), v_((normal_ + 2) % 3), distance_(distance) {}

  double distance() const { return distance_; }
  std::string axisName() const { return std::string(1, static_cast<char>('x' + normal_)); }
  Eigen::Vector3d normal() const { return Eigen::Vector3d::Unit(normal_); }

  Eigen::Vector2d toLocal(const Eigen::Vector3d& p) const { return {p[u_], p[v_]}; }
  double along(const Eigen::Vector3d& p) const { return p[normal_]; }
  Eigen::Vector3d toGlobal(const Eigen::Vector2d& local, double along_normal) const {
    Eigen::Vector3d p;
    p[u_] = local.x();
    p[v_] = local.y();
    p[normal_] = along_normal;
    return p;
  }

  /// The rotation about the normal in an orientation, in [-pi, pi] [rad].
  double headingOf(const Eigen::Quaterniond& orientation) const;
  /// An orientation without its heading.
  Eigen::Quaterniond baseOf(const Eigen::Quaterniond& orientation) const;
  Eigen::Quaterniond orientation(double heading, const Eigen::Quaterniond& base) const;
  /// Whether body z is along the normal or opposite to it.
  bool isUpright(const Eigen::Quaterniond& orientation) const;

 private:
  int normal_ = 2;
  int u_ = 0;
  int v_ = 1;
  double distance_ = 0.0;
};

}  // namespace swarmanoid::planar

#include "planar/plane.hpp"

#include <cmath>

#include "swarmanoid_interface/angle.hpp"

namespace swarmanoid::planar {

double Plane::headingOf(const Eigen::Quaterniond& orientation) const {
  return wrapAngle(2.0 * std::atan2(orientation.vec()[normal_], orientation.w()));
}

Eigen::Quaterniond Plane::baseOf(const Eigen::Quaterniond& orientation) const {
  const Eigen::AngleAxisd back(-headingOf(orientation), normal());
  const Eigen::Quaterniond base = (back * orientation).normalized();
  // rounding must not make the bases of two upright bodies differ
  constexpr double kNothing = 1e-12;
  return base.vec().norm() < kNothing ? Eigen::Quaterniond::Identity() : base;
}

bool Plane::isUpright(const Eigen::Quaterniond& orientation) const {
  constexpr double kUpright = 1.0 - 1e-9;
  return std::abs(along(orientation * Eigen::Vector3d::UnitZ())) >= kUpright;
}

Eigen::Quaterniond Plane::orientation(double heading, const Eigen::Quaterniond& base) const {
  Eigen::Quaterniond turn = Eigen::Quaterniond::Identity();
  turn.w() = std::cos(0.5 * heading);
  turn.vec()[normal_] = std::sin(0.5 * heading);
  return base.vec().isZero(0.0) ? turn : turn * base;
}

}  // namespace swarmanoid::planar

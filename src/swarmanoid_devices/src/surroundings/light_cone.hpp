/// Directions in which a lamp shines: all, or a cone (swarmanoid_space/models/spot_light.hpp).
#pragma once

#include <Eigen/Core>
#include <cmath>

#include "swarmanoid_space/models/spot_light.hpp"
#include "swarmanoid_space/space.hpp"

namespace swarmanoid::devices {

struct LightCone {
  Eigen::Vector3d axis = Eigen::Vector3d::UnitX();  ///< in W, of length 1
  double cosine = -1.0;                             ///< of half the opening angle; -1: all directions

  /// Whether it shines in all directions.
  bool isWhole() const { return cosine <= -1.0; }
  /// Whether a point is in the cone. @param way from the lamp to the point, in W [m]
  bool holds(const Eigen::Vector3d& way) const { return isWhole() || axis.dot(way) >= cosine * way.norm(); }
};

/// @param lamp any entity; all except spot lights shine in all directions
inline LightCone lightConeOf(const Space& space, Row lamp) {
  LightCone cone;
  if (const std::optional<double> aperture = space.property(lamp, kAperture)) {
    cone.axis = space.entities.pose[lamp].orientation * Eigen::Vector3d::UnitX();
    cone.cosine = std::cos(0.5 * *aperture * M_PI / 180.0);
  }
  return cone;
}

}  // namespace swarmanoid::devices

/// Into which directions a lamp shines: all, or a cone (swarmanoid_space/models/spot_light.hpp).
#pragma once

#include <Eigen/Core>
#include <cmath>

#include "swarmanoid_space/models/spot_light.hpp"
#include "swarmanoid_space/space.hpp"

namespace swarmanoid::devices {

struct LightCone {
  Eigen::Vector3d axis = Eigen::Vector3d::UnitX();  ///< in W, of length 1
  double cosine = -1.0;                             ///< of half the angle; -1: it shines everywhere

  /// Whether it shines everywhere.
  bool isWhole() const { return cosine <= -1.0; }
  /// Whether its light falls there. @param way from the lamp, in W [m]
  bool holds(const Eigen::Vector3d& way) const { return isWhole() || axis.dot(way) >= cosine * way.norm(); }
};

/// @param lamp or anything else, which shines everywhere
inline LightCone lightConeOf(const Space& space, Row lamp) {
  LightCone cone;
  if (const std::optional<double> aperture = space.property(lamp, kAperture)) {
    cone.axis = space.entities.pose[lamp].orientation * Eigen::Vector3d::UnitX();
    cone.cosine = std::cos(0.5 * *aperture * M_PI / 180.0);
  }
  return cone;
}

}  // namespace swarmanoid::devices

#include "swarmanoid_space/models/battery_model.hpp"

#include <cmath>

#include "swarmanoid_interface/expects.hpp"

namespace swarmanoid {

double hoverPower(double mass, double area, double efficiency) {
  SWARMANOID_EXPECTS(area > 0.0 && efficiency > 0.0);
  const double weight = mass * BatteryModel::kGravity;
  return std::sqrt(weight * weight * weight / (2.0 * BatteryModel::kAirDensity * area)) / efficiency;
}

}  // namespace swarmanoid

// The eyebot's altimeter: one ray along the body's -z axis, which ends on the ground or on the first solid.
#include "swarmanoid_interface/devices/eyebot_altitude.hpp"

#include <algorithm>

#include "common/parameters.hpp"
#include "surroundings/way_to_ground.hpp"
#include "swarmanoid_space/sensor.hpp"

namespace swarmanoid::devices {
namespace {

class EyebotAltitudeSensor final : public SensorOf<EyebotAltitude> {
 public:
  static PluginDescription describe() {
    PluginDescription description;
    description.label = EyebotAltitude::kType;
    description.implementation = "default";
    description.is_default = true;
    description.summary = "The distance along one ray downwards.";
    description.parameters = {number("range", "m", numberText(EyebotAltitude::kUsualRange),
                                     {EyebotAltitude::kNearest, EyebotAltitude::kFarthest},
                                     "The farthest distance that is measured.")};
    return description;
  }

  void configure(const Configuration& parameters) override {
    range_ = parameters.number("range", EyebotAltitude::kUsualRange);
  }

  void sense(const Space& space, std::size_t first, std::size_t last) override {
    for (std::size_t k = first; k < last; ++k) {
      EyebotAltitude& readings = *instances_[k].readings;
      readings.range_max = static_cast<float>(range_);
      const double distance = distanceBelow(space, instances_[k].row);
      readings.distance = Distance::reading(distance, {EyebotAltitude::kNearest, range_});
    }
  }

 private:
  /// @return at least 0; infinity without a hit [m]
  double distanceBelow(const Space& space, Row row) const {
    const Pose& pose = space.entities.pose[row];
    const Eigen::Vector3d down = pose.orientation * -Eigen::Vector3d::UnitZ();
    const double to_ground = wayToGround(space, pose.position, down, range_);
    // starts within the body, since bodies penetrate their support slightly
    const RayHit hit = space.castRay({pose.position - kDeepestSpot * down, pose.position + range_ * down}, row);
    const double to_hit = hit.isHit() ? hit.fraction * (kDeepestSpot + range_) - kDeepestSpot : kInfinity;
    return std::max(0.0, std::min(to_ground, to_hit));
  }

  double range_ = EyebotAltitude::kUsualRange;
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_SENSOR(swarmanoid::devices::EyebotAltitudeSensor)

// The laser pointer: it makes a red spot where its beam hits the first surface or the ground; none in a hole of the
// floor.
#include "swarmanoid_interface/devices/eyebot_laser.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "common/parameters.hpp"
#include "swarmanoid_space/actuator.hpp"

namespace swarmanoid::devices {
namespace {

class EyebotLaserActuator final : public ActuatorOf<EyebotLaser> {
 public:
  static PluginDescription describe() {
    PluginDescription description;
    description.label = EyebotLaser::kType;
    description.implementation = "default";
    description.is_default = true;
    description.summary = "A laser pointer that makes a red spot on the surface below.";
    description.parameters = {angle("noise", "0", {0.0, 10.0}, "Standard deviation added to the beam's tilt.")};
    return description;
  }

  void configure(const Configuration& parameters) override {
    addErrorAlias("gaussian", "tilt", "deviation", parameters.angle("noise", 0.0));
  }

  void afterMove(const Space& space, const AfterMoveAccess& access) override {
    access.laser_spots.reserve(access.laser_spots.size() + instances_.size());
    for (const auto& instance : instances_) {
      if (instance.actuation->on) {
        const LaserSpot spot = spotOf(space, instance);
        const bool is_on_floor = std::abs(spot.position.z()) < kOnFloor;
        if (!is_on_floor || space.holeAt(spot.position) == nullptr) {
          access.laser_spots.push_back(spot);
        }
      }
    }
  }

 protected:
  void limit(const Space& /*space*/, BasicActuatorInstance<EyebotLaser>& instance) override {
    limitToRanges(*instance.actuation);
  }

 private:
  static constexpr double kOnFloor = 1e-6;  // m
  static constexpr double kReach = 20.0;    // m

  /// The beam from a point to the floor, at most to its range. Where terrain replaces the floor, it extends to the
  /// lowest height of the ground, so that a ray along it hits the terrain. @param direction of length 1
  static Segment beamToGround(const Space& space, const Eigen::Vector3d& from, const Eigen::Vector3d& direction) {
    const auto downTo = [&](double height) -> Eigen::Vector3d {
      const double way = direction.z() < 0.0 ? (height - from.z()) / direction.z() : kReach;
      return from + std::clamp(way, 0.0, kReach) * direction;
    };
    const Eigen::Vector3d on_floor = downTo(0.0);
    if (space.terrain && space.terrain->contains(on_floor.x(), on_floor.y())) {
      return {from, downTo(space.lowestGround())};
    }
    return {from, on_floor};
  }

  static LaserSpot spotOf(const Space& space, const BasicActuatorInstance<EyebotLaser>& instance) {
    const Pose& pose = space.entities.pose[instance.row];
    const double sine = std::sin(instance.actuation->tilt);
    const Eigen::Vector3d direction(sine * std::cos(instance.actuation->pan), sine * std::sin(instance.actuation->pan),
                                    -std::cos(instance.actuation->tilt));
    const Eigen::Vector3d pointer = pose.toWorld(space.entities.model[instance.row]->mount("laser_pointer").position);
    const Segment beam = beamToGround(space, pointer, pose.orientation * direction);
    const RayHit hit = space.castRay(beam, instance.row);
    return {instance.number, beam.from, beam.from + hit.fraction * (beam.to - beam.from), colors::kRed};
  }
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_ACTUATOR(swarmanoid::devices::EyebotLaserActuator)

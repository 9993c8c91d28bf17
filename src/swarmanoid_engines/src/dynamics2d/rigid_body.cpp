#include "dynamics2d/rigid_body.hpp"

namespace swarmanoid::dynamics2d {

planar::PlacedPose RigidBody::pose(const planar::PlacedPose& similar) const {
  planar::PlacedPose pose = planar::PlacedPose::at(centre, heading, similar);
  if (!arm.isZero(0.0)) {
    pose.position -= pose.rotated(arm);
  }
  return pose;
}

}  // namespace swarmanoid::dynamics2d

#include "planar/gripper_reach.hpp"

#include <limits>

#include "swarmanoid_interface/expects.hpp"

namespace swarmanoid::planar {

GripperTip gripperTip(const Bodies& bodies, BodyIndex index) {
  const Body& body = bodies[index];
  SWARMANOID_EXPECTS(body.entity->gripper.has_value());
  const EntityModel::Gripper& gripper = *body.entity->gripper;
  const Plane& plane = bodies.plane();
  Eigen::Vector3d arm(gripper.tip, 0.0, gripper.height);
  if (const Turret* turret = bodies.findTurret(index); turret != nullptr && turret->state.angle != 0.0) {
    arm = Eigen::AngleAxisd(turret->state.angle, Eigen::Vector3d::UnitZ()) * arm;
  }
  arm = bodies.details(index).base * arm;
  return {body.pose.position + body.pose.rotated(plane.toLocal(arm)), body.along + plane.along(arm)};
}

double distanceToStrip(const Bodies& bodies, BodyIndex index, const GripperTip& tip) {
  const Body& body = bodies[index];
  const bool is_at_height =
      tip.along >= body.along + body.model->band.low && tip.along <= body.along + body.model->band.high;
  if (!body.entity->gripping_radius || !is_at_height || !bodies.plane().isUpright(bodies.details(index).base)) {
    return std::numeric_limits<double>::infinity();
  }
  return std::abs((body.pose.position - tip.position).norm() - *body.entity->gripping_radius);
}

}  // namespace swarmanoid::planar

#include "dynamics3d/body.hpp"

#include <algorithm>

#include "dynamics3d/solids.hpp"

namespace swarmanoid::dynamics3d {

Body::~Body() {
  if (grip.joint != nullptr) {
    dJointDestroy(grip.joint);
  }
  for (const Solid& solid : solids) {
    dGeomDestroy(solid.geom);
  }
  if (rigid != nullptr) {
    dBodyDestroy(rigid);
  }
}

Pose Body::currentPose() const {
  const Eigen::Quaterniond orientation = toQuaternion(dBodyGetQuaternion(rigid));
  return {toVector(dBodyGetPosition(rigid)) - orientation * model->centre_of_mass, orientation};
}

Twist Body::currentTwist() const {
  const Eigen::Vector3d angular = toVector(dBodyGetAngularVel(rigid));
  const Eigen::Vector3d arm = toQuaternion(dBodyGetQuaternion(rigid)) * model->centre_of_mass;
  return {toVector(dBodyGetLinearVel(rigid)) - angular.cross(arm), angular};
}

void Body::setPose(const Pose& new_pose) {
  pose = new_pose;
  if (rigid == nullptr) {
    for (std::size_t i = 0; i < solids.size(); ++i) {
      const CollisionShape& shape = model->shapes[i];
      setGeomPose(solids[i].geom, pose.position + pose.orientation * shape.position,
                  pose.orientation * shape.orientation);
    }
    return;
  }
  const Eigen::Vector3d centre = pose.position + pose.orientation * model->centre_of_mass;
  const Eigen::Quaterniond& turn = pose.orientation;
  const dQuaternion q = {turn.w(), turn.x(), turn.y(), turn.z()};
  dBodySetPosition(rigid, centre.x(), centre.y(), centre.z());
  dBodySetQuaternion(rigid, q);
}

void Body::setTwist(const Twist& twist) {
  const Eigen::Vector3d arm = toQuaternion(dBodyGetQuaternion(rigid)) * model->centre_of_mass;
  const Eigen::Vector3d linear = twist.linear + twist.angular.cross(arm);
  dBodySetLinearVel(rigid, linear.x(), linear.y(), linear.z());
  dBodySetAngularVel(rigid, twist.angular.x(), twist.angular.y(), twist.angular.z());
}

void Body::saveState() {
  if (rigid == nullptr) {
    return;
  }
  std::copy_n(dBodyGetPosition(rigid), 3, saved_.position);
  std::copy_n(dBodyGetQuaternion(rigid), 4, saved_.orientation);
  std::copy_n(dBodyGetLinearVel(rigid), 3, saved_.linear);
  std::copy_n(dBodyGetAngularVel(rigid), 3, saved_.angular);
  std::copy_n(dBodyGetForce(rigid), 3, saved_.force);
  std::copy_n(dBodyGetTorque(rigid), 3, saved_.torque);
}

void Body::restoreState() {
  if (rigid == nullptr) {
    return;
  }
  dBodySetPosition(rigid, saved_.position[0], saved_.position[1], saved_.position[2]);
  dBodySetQuaternion(rigid, saved_.orientation);
  dBodySetLinearVel(rigid, saved_.linear[0], saved_.linear[1], saved_.linear[2]);
  dBodySetAngularVel(rigid, saved_.angular[0], saved_.angular[1], saved_.angular[2]);
  dBodySetForce(rigid, saved_.force[0], saved_.force[1], saved_.force[2]);
  dBodySetTorque(rigid, saved_.torque[0], saved_.torque[1], saved_.torque[2]);
}

std::unique_ptr<Body> makeBody(dWorldID world, const Space& space, Row row, Role role) {
  const auto i = static_cast<std::size_t>(row);
  auto body = std::make_unique<Body>();
  body->number = space.entities.number[i];
  body->row = row;
  body->role = role;
  body->model = space.entities.model[i];
  const EntityModel& model = *body->model;
  if (model.is_movable) {
    body->is_dynamic = role == Role::kMove;
    body->rigid = dBodyCreate(world);
    if (body->is_dynamic) {
      dMass mass;
      const Eigen::Matrix3d& inertia = model.inertia;
      dMassSetParameters(&mass, model.mass, 0.0, 0.0, 0.0, inertia(0, 0), inertia(1, 1), inertia(2, 2), inertia(0, 1),
                         inertia(0, 2), inertia(1, 2));
      dBodySetMass(body->rigid, &mass);
    } else {
      dBodySetKinematic(body->rigid);
    }
  }
  addSolids(*body);
  return body;
}

}  // namespace swarmanoid::dynamics3d

#include "dynamics3d/body.hpp"

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

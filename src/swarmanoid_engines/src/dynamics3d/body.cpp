#include "dynamics3d/body.hpp"

#include <algorithm>

#include "common/grips.hpp"
#include "dynamics3d/collision/solids.hpp"
#include "dynamics3d/mechanisms/arms.hpp"
#include "swarmanoid_interface/expects.hpp"

namespace swarmanoid::dynamics3d {
namespace {

void setMass(dBodyID rigid, const Inertial& inertial) {
  dMass mass;
  const Eigen::Matrix3d& inertia = inertial.inertia;
  dMassSetParameters(&mass, inertial.mass, 0.0, 0.0, 0.0, inertia(0, 0), inertia(1, 1), inertia(2, 2), inertia(0, 1),
                     inertia(0, 2), inertia(1, 2));
  dBodySetMass(rigid, &mass);
}

bool isGripper(const EntityModel::Holder& holder) { return holder.kind == EntityModel::Holder::Kind::kGripper; }

/// Whether a holder other than a gripper is commanded.
bool isHoldingCommanded(const Space& space, Row row) {
  const EntityModel& model = *space.entities.model[row];
  const Span<const HolderCommand> commands = space.holder_commands[row];
  for (std::size_t i = 0; i < commands.size(); ++i) {
    if (commands[i].is_commanded && !isGripper(model.holders[i])) {
      return true;
    }
  }
  return false;
}

/// Whether a joint other than a turret is commanded.
bool areLinksCommanded(const Space& space, Row row) {
  const int turret = turretJoint(*space.entities.model[row]);
  const Span<const JointCommand> commands = space.joint_commands[row];
  for (std::size_t i = 0; i < commands.size(); ++i) {
    if (commands[i].mode != JointCommand::Mode::kNone && static_cast<int>(i) != turret) {
      return true;
    }
  }
  return false;
}

}  // namespace

Body::~Body() {
  if (grip.joint != nullptr) {
    dJointDestroy(grip.joint);
  }
  if (holding != nullptr) {
    for (const Grip& hold : holding->grips) {
      if (hold.joint != nullptr) {
        dJointDestroy(hold.joint);
      }
    }
  }
  for (const Solid& solid : solids) {
    dGeomDestroy(solid.geom);
  }
  for (const Link& link : links) {
    dJointDestroy(link.stop);
    dJointDestroy(link.hinge);
    dBodyDestroy(link.rigid);
  }
  if (rigid != nullptr) {
    dBodyDestroy(rigid);
  }
}

Pose Body::currentPose() const {
  SWARMANOID_EXPECTS(rigid != nullptr);
  const Eigen::Quaterniond orientation = toQuaternion(dBodyGetQuaternion(rigid));
  return {toVector(dBodyGetPosition(rigid)) - orientation * own.centre_of_mass, orientation};
}

Twist Body::currentTwist() const {
  SWARMANOID_EXPECTS(rigid != nullptr);
  const Eigen::Vector3d angular = toVector(dBodyGetAngularVel(rigid));
  const Eigen::Vector3d arm = toQuaternion(dBodyGetQuaternion(rigid)) * own.centre_of_mass;
  return {toVector(dBodyGetLinearVel(rigid)) - angular.cross(arm), angular};
}

void Body::setPose(const Pose& new_pose, Span<const JointState> joints) {
  pose = new_pose;
  if (rigid == nullptr) {
    for (std::size_t i = 0; i < solids.size(); ++i) {
      const CollisionShape& shape = model->shapes[i];
      setGeomPose(solids[i].geom, pose.toWorld(shape.position), pose.orientation * shape.orientation);
    }
    return;
  }
  setBodyPose(rigid, pose.toWorld(own.centre_of_mass), pose.orientation);
  if (!links.empty()) {
    placeLinks(*this, joints);
  } else if (posed_ != nullptr && !joints.empty() && turret.joint < 0) {
    turnSolids(*this, joints);
  }
  if (!joints.empty()) {
    poseShapes(joints);
  }
}

void Body::setTwist(const Twist& twist, Span<const JointState> joints) {
  SWARMANOID_EXPECTS(rigid != nullptr);
  const Eigen::Vector3d arm = toQuaternion(dBodyGetQuaternion(rigid)) * own.centre_of_mass;
  const Eigen::Vector3d linear = twist.linear + twist.angular.cross(arm);
  dBodySetLinearVel(rigid, linear.x(), linear.y(), linear.z());
  dBodySetAngularVel(rigid, twist.angular.x(), twist.angular.y(), twist.angular.z());
  moveLinks(*this, twist, joints);
}

void Body::poseShapes(Span<const JointState> joints) {
  if (posed_ == nullptr) {
    return;
  }
  for (std::size_t i = 0; i < model->shapes.size(); ++i) {
    if (model->shapes[i].joint >= 0) {
      posed_->shapes[i] = placeOf(*model, joints, model->shapes[i]);
    }
  }
  posed_->measureShapes();
}

template <class Visit>
void Body::visitRigids(Visit visit) {
  if (rigid == nullptr) {
    return;
  }
  visit(rigid, saved_[0]);
  for (std::size_t i = 0; i < links.size(); ++i) {
    visit(links[i].rigid, saved_[i + 1]);
  }
}

void Body::saveState() {
  visitRigids([](dBodyID part, State& saved) {
    std::copy_n(dBodyGetPosition(part), 3, saved.position);
    std::copy_n(dBodyGetQuaternion(part), 4, saved.orientation);
    std::copy_n(dBodyGetLinearVel(part), 3, saved.linear);
    std::copy_n(dBodyGetAngularVel(part), 3, saved.angular);
    std::copy_n(dBodyGetForce(part), 3, saved.force);
    std::copy_n(dBodyGetTorque(part), 3, saved.torque);
  });
}

void Body::restoreState() {
  visitRigids([](dBodyID part, const State& saved) {
    dBodySetPosition(part, saved.position[0], saved.position[1], saved.position[2]);
    dBodySetQuaternion(part, saved.orientation);
    dBodySetLinearVel(part, saved.linear[0], saved.linear[1], saved.linear[2]);
    dBodySetAngularVel(part, saved.angular[0], saved.angular[1], saved.angular[2]);
    dBodySetForce(part, saved.force[0], saved.force[1], saved.force[2]);
    dBodySetTorque(part, saved.torque[0], saved.torque[1], saved.torque[2]);
  });
}

void readCommands(const Space& space, Body& body) {
  body.wheels_command = space.wheels[body.row];
  body.flight_command = space.flight[body.row];
  const Span<const JointCommand> joints = space.joint_commands[body.row];
  for (std::size_t i = 0; i < body.links.size(); ++i) {
    body.links[i].command = joints[i];
  }
  if (body.turret.joint >= 0) {
    body.turret.command = joints[static_cast<std::size_t>(body.turret.joint)];
  }
  if (body.holding != nullptr) {
    for (std::size_t i = 0; i < body.holding->ropes.size(); ++i) {
      body.holding->ropes[i].wanted_winding = space.holder_commands[body.row][i].winding_speed;
    }
  }
}

std::unique_ptr<Body> makeBody(dWorldID world, const Space& space, Row row, Role role) {
  SWARMANOID_EXPECTS(OdeLock::isHeld());
  auto body = std::make_unique<Body>();
  body->number = space.entities.number[row];
  body->row = row;
  body->role = role;
  body->model = space.entities.model[row];
  const EntityModel& model = *body->model;
  body->own = {model.mass, model.centre_of_mass, model.inertia};
  body->gripper = commandedGripper(space, row);
  if (isHoldingCommanded(space, row)) {
    body->holding = std::make_unique<Holding>(model);
  }
  if (model.is_movable) {
    body->is_dynamic = role == Role::kMove;
    body->rigid = dBodyCreate(world);
    if (body->is_dynamic && areLinksCommanded(space, row)) {
      body->own = model.body_part;
      body->links = makeLinks(world, *body);
    }
    if (body->is_dynamic) {
      setMass(body->rigid, body->own);
    } else {
      dBodySetKinematic(body->rigid);
    }
    for (std::size_t k = 0; k < body->links.size(); ++k) {
      setMass(body->links[k].rigid, model.joints[k].part);
    }
    dBodySetData(body->rigid, body.get());
    for (const Link& link : body->links) {
      dBodySetData(link.rigid, body.get());
    }
    body->saved_.resize(1 + body->links.size());
  }
  addSolids(*body);
  if (std::any_of(model.shapes.begin(), model.shapes.end(), [](const CollisionShape& s) { return s.joint >= 0; })) {
    body->posed_ = std::make_unique<EntityModel>();
    body->posed_->type = model.type;
    body->posed_->shapes = model.shapes;
    body->posed_->measureShapes();
  }
  return body;
}

}  // namespace swarmanoid::dynamics3d

// Turrets: motors between robots and the bodies they hold; grippers that turn without load.
#include <algorithm>
#include <cmath>

#include "dynamics2d/dynamics2d.hpp"
#include "swarmanoid_interface/angle.hpp"

namespace swarmanoid::dynamics2d {

using planar::Turret;

void Dynamics2d::driveTurrets(double step) {
  for (GripConstraint& grip : island_.grips) {
    if (grip.kind != GripConstraint::Kind::kRigid) {
      aimTurret(grip, step);
    }
  }
  for (std::size_t i = 0; i < movable_members_; ++i) {
    const BodyIndex index = members_[i];
    Turret* turret = bodies_.findTurret(index);
    if (turret != nullptr && !rigid(index).grip.isHolding()) {
      turnFreely(*turret, step);
    }
  }
}

void Dynamics2d::turnFreely(Turret& turret, double step) {
  const double angle = freeTurn(turret.command, bodies_.jointOf(turret), turret.state.angle, step);
  turret.state.speed = 0.0;
  turret.state.effort = 0.0;
  if (angle == turret.state.angle) {
    return;
  }
  if (rigid(turret.body).is_present) {
    constexpr double kTouching = -1e-5;  // m
    const double reached = gapAround(turret, bodies_.modelAt(turret, angle));
    if (reached < kTouching && reached < gapAround(turret, *bodies_[turret.body].model)) {
      return;
    }
  }
  turret.state.speed = wrapTurn(angle - turret.state.angle) / step;
  turret.state.angle = angle;
  turnGripper(turret);
}

double Dynamics2d::gapAround(const Turret& turret, const PlanarModel& model) {
  constexpr double kFar = 1e-3;  // m
  const RigidBody& rigid_body = rigid(turret.body);
  const EntityModel& entity = *bodies_[turret.body].entity;
  makeContactShapes(model, rigid_body.arm, tried_shapes_);
  const auto stands = [&](const ContactShape& shape) { return entity.shapes[shape.number].joint != turret.joint; };
  tried_shapes_.erase(std::remove_if(tried_shapes_.begin(), tried_shapes_.end(), stands), tried_shapes_.end());
  return island_.gapAround(rigid_body.place, tried_shapes_, kFar);
}

void Dynamics2d::turnGripper(const Turret& turret) {
  RigidBody& rigid_body = rigid(turret.body);
  bodies_.turnShapes(turret, turret.state.angle);
  if (rigid_body.is_present) {
    makeContactShapes(*bodies_[turret.body].model, rigid_body.arm, rigid_body.shapes);
  } else {
    rigid_body.shapes.clear();
  }
}

void Dynamics2d::aimTurret(GripConstraint& grip, double step) {
  const Turret& turret = *bodies_.findTurret(members_[static_cast<std::size_t>(grip.gripper)]);
  const EntityModel::Joint& joint = bodies_.jointOf(turret);
  const bool is_passive = turret.command.mode == JointCommand::Mode::kPassive;
  grip.kind = is_passive ? GripConstraint::Kind::kPassive : GripConstraint::Kind::kMotor;
  grip.turn_impulse = is_passive ? 0.0 : grip.turn_impulse;
  grip.speed = turret.sense * motorSpeed(turret.command, joint, turret.state.angle, step);
  grip.most_turn = joint.max_effort * step;
}

void Dynamics2d::readTurret(const GripConstraint& grip, double step) {
  Turret& turret = *bodies_.findTurret(members_[static_cast<std::size_t>(grip.gripper)]);
  const SolverBody& robot = island_.bodies[static_cast<std::size_t>(grip.gripper)];
  const SolverBody& held = island_.bodies[static_cast<std::size_t>(grip.held)];
  const double turned = held.pose.heading - robot.pose.heading - turret.held.heading;
  turret.state = {wrapTurn(turret.sense * turned), turret.sense * (held.spin - robot.spin),
                  turret.sense * grip.turn_impulse / step};
}

void Dynamics2d::finishTurrets(const MoveAccess& access) {
  constexpr double kSeen = 1e-4;  // rad: a held angle oscillates by less
  for (const Turret& turret : bodies_.turrets()) {
    if (std::abs(wrapTurn(turret.state.angle - bodies_.shapesAngle(turret))) > kSeen) {
      turnGripper(turret);
    }
    access.joints[bodies_[turret.body].row][turret.joint] = turret.state;
  }
}

}  // namespace swarmanoid::dynamics2d

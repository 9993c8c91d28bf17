// Phase `move`: turrets, and the bodies that their grippers hold.
#include <algorithm>
#include <cmath>

#include "kinematics2d/kinematics2d.hpp"
#include "kinematics2d/try_parts.hpp"
#include "swarmanoid_interface/angle.hpp"

namespace swarmanoid::kinematics2d {

using planar::Turret;

/// @return upper bound on the speed of a body that a turning turret holds [m/s]
double Kinematics2d::startTurrets(double step) {
  double fastest = 0.0;
  for (Turret& turret : bodies_.turrets()) {
    turret.angle_at_start = turret.state.angle;
    if (motion(turret.body).gripped == kNoBody) {
      continue;
    }
    const Body& body = bodies_[turret.body];
    const double next = freeTurn(turret.command, bodies_.jointOf(turret), turret.state.angle, step);
    const double turn_rate = std::abs(wrapTurn(next - turret.state.angle)) / step + std::abs(body.turn_rate);
    const double arm = motion(turret.body).place_of_gripped.position.norm();
    fastest = std::max(fastest, body.velocity.norm() + arm * turn_rate);
  }
  return fastest;
}

void Kinematics2d::turn(Turret& turret, double dt) {
  if (isInGroup(turret.body)) {
    return;
  }
  const double start = turret.state.angle;
  const double angle = freeTurn(turret.command, bodies_.jointOf(turret), start, dt);
  const PlacedPose& pose = bodies_[turret.body].pose;
  if (angle != start && !tryTurned(turret, pose, angle)) {
    tryParts([&](double part) { return tryTurned(turret, pose, wrapTurn(start + part * wrapTurn(angle - start))); });
  }
}

bool Kinematics2d::tryTurned(Turret& turret, const PlacedPose& pose, double angle) {
  const BodyIndex index = turret.body;
  Motion& record = motion(index);
  const BodyIndex gripped = record.gripped;
  Clearance around = clearance(index);
  if (gripped != kNoBody || travelled(all_) > around.free_until) {
    const planar::PlanarModel* now = bodies_[index].model;
    bodies_[index].model = &bodies_.modelAt(turret, angle);
    const bool is_free = isFree(index, pose, around, all_);
    bodies_[index].model = now;
    if (!is_free) {
      return false;
    }
  }
  if (gripped != kNoBody) {
    const planar::PlanarPose place = placeOfHeld(turret, angle);
    if (!tryCarry(index, pose, place)) {
      return false;
    }
    record.place_of_gripped = place;
    around.free_until = -1.0;  // as in tryPose
  }
  clearance(index) = around;
  bodies_.setPose(index, pose);
  bodies_.turnShapes(turret, angle);
  turret.state.angle = angle;
  return true;
}

planar::PlanarPose Kinematics2d::placeOfHeld(const Turret& turret, double angle) const {
  const double turned = turret.sense * angle;
  const PlacedPose frame = PlacedPose::at(Eigen::Vector2d::Zero(), turned);
  return {frame.rotated(turret.held.position), turret.held.heading + turned};
}

double Kinematics2d::trailingAngle(const Turret& turret, const PlacedPose& pose) const {
  const PlacedPose& before = bodies_[turret.body].pose;
  const Eigen::Vector2d held = bodies_[motion(turret.body).gripped].pose.position;
  const Eigen::Vector2d from = held - before.position;
  const Eigen::Vector2d to = held - pose.position;
  const double swung = std::atan2(planar::cross(from, to), from.dot(to));
  return wrapTurn(turret.state.angle + turret.sense * (swung - (pose.heading - before.heading)));
}

void Kinematics2d::finishTurrets(const MoveAccess& access, double dt) {
  for (Turret& turret : bodies_.turrets()) {
    turret.state.speed = wrapTurn(turret.state.angle - turret.angle_at_start) / dt;
    turret.state.effort = 0.0;
    access.joints[bodies_[turret.body].row][turret.joint] = turret.state;
  }
}

}  // namespace swarmanoid::kinematics2d

// Phase `move`: from commands to poses and twists.
#include <algorithm>
#include <cmath>

#include "dynamics2d/dynamics2d.hpp"
#include "swarmanoid_interface/angle.hpp"

namespace swarmanoid::dynamics2d {

void Dynamics2d::readMirrors(const Space& space) {
  mirrors_.clear();
  for (const BodyIndex index : bodies_.order()) {
    const Body& body = bodies_[index];
    if (body.role == Role::kMirror && body.is_movable) {
      const Eigen::Vector2d before = body.pose.position;
      const double radius = body.model->radius;
      takePose(space, index);
      mirrors_.push_back(index);
      rigid(index).jump = (body.pose.position - before).norm() + std::max(0.0, body.model->radius - radius);
    }
  }
}

void Dynamics2d::move(const Space& space, const MoveAccess& access, Duration dt) {
  const double tick = toSeconds(dt);
  startTick(space, tick);
  moveAlone(tick);
  moveIslands(tick);
  finishTick(space, access, tick);
  finishTurrets(access);
}

void Dynamics2d::startTick(const Space& space, double tick) {
  bodies_.readTurretCommands(space);
  longest_way_ = 0.0;
  longest_slow_way_ = 0.0;
  for (const BodyIndex index : movers_) {
    Body& body = bodies_[index];
    if (body.isDriven()) {
      readCommands(space, body);
    }
    measureWay(index, tick, 0.0);
  }
  for (const BodyIndex index : mirrors_) {
    measureWay(index, tick, rigid(index).jump);
  }
  sortOut();
  for (const BodyIndex index : movers_) {
    if (bodies_[index].isDriven() && !rigid(index).is_present) {
      prepareDrive(index, tick / subclock_);
    }
  }
}

void Dynamics2d::finishTick(const Space& space, const MoveAccess& access, double tick) {
  crowd_memory_.finishTick();
  const planar::Plane& plane = bodies_.plane();
  for (const BodyIndex index : movers_) {
    RigidBody& rigid_body = rigid(index);
    rigid_body.heading = wrapAngle(rigid_body.heading);
    const planar::PlacedPose before = bodies_[index].pose;
    const planar::PlacedPose pose = rigid_body.pose(before);
    turnWheels(space, access, bodies_[index], tick);
    Twist& twist = access.twist[bodies_[index].row];
    const Eigen::Vector2d arm = pose.rotated(rigid_body.arm);
    const Eigen::Vector2d velocity = rigid_body.velocity - rigid_body.spin * Eigen::Vector2d(-arm.y(), arm.x());
    twist.linear = plane.toGlobal(velocity, 0.0);
    twist.angular = plane.normal() * rigid_body.spin;
    if (pose.position != before.position || pose.heading != before.heading) {
      bodies_.setPose(index, pose);
      writePose(access, index, before.heading);
    }
  }
}

}  // namespace swarmanoid::dynamics2d

// Phase `move`: a body with several grippers moves by the mean of their ways, and the grippers go along.
#include <algorithm>
#include <cmath>

#include "kinematics2d/kinematics2d.hpp"
#include "kinematics2d/try_parts.hpp"
#include "swarmanoid_interface/angle.hpp"

namespace swarmanoid::kinematics2d {
namespace {

/// Pose of a gripper, from the pose of the body it grips and the place of that body in the gripper's frame.
PlacedPose gripperPose(const PlacedPose& gripped, const planar::PlanarPose& place) {
  const PlacedPose gripper = PlacedPose::at(gripped.position, wrapAngle(gripped.heading - place.heading));
  return PlacedPose::at(gripped.position - gripper.rotated(place.position), gripper.heading);
}

PlacedPose moved(const PlacedPose& start, const planar::PlanarPose& way, double part, double turned) {
  return PlacedPose::at(start.position + part * way.position, wrapAngle(start.heading + turned * way.heading));
}

}  // namespace

/// @return upper bound on speeds in groups: the mean of the ways that the grippers would give the gripped body, and the
/// swing around it by the mean of their turns [m/s]
double Kinematics2d::fastestOfGroups() const {
  double speed = 0.0;
  double turn_rate = 0.0;
  double arm = 0.0;
  for (const BodyIndex index : grippers_) {
    if (isInGroup(index)) {
      const Body& body = bodies_[index];
      speed = std::max(speed, body.velocity.norm());
      turn_rate = std::max(turn_rate, std::abs(body.turn_rate));
      arm = std::max(arm, motion(index).place_of_gripped.position.norm());
    }
  }
  return speed + 2.0 * arm * turn_rate;
}

/// Moves a group in pieces, as a single body, each piece as far as all of the group have room.
void Kinematics2d::moveGroup(BodyIndex gripped, double dt) {
  const planar::PlanarPose whole = wayOfGroup(gripped, dt);
  if (whole.position.isZero(0.0) && whole.heading == 0.0) {
    return;
  }
  double smallest = bodies_[gripped].model->inner_radius;
  double arm = 0.0;
  for (BodyIndex index = motion(gripped).gripped_by; index != kNoBody; index = motion(index).next_gripper) {
    smallest = std::min(smallest, bodies_[index].model->inner_radius);
    arm = std::max(arm, motion(index).place_of_gripped.position.norm());
  }
  // grippers also swing around the gripped body
  const double way_of_farthest = whole.position.norm() + arm * std::abs(whole.heading);
  const int pieces = std::max(1, static_cast<int>(std::ceil(way_of_farthest / (0.5 * smallest))));
  for (int i = 0; i < pieces; ++i) {
    const planar::PlanarPose way = wayOfGroup(gripped, dt / pieces);
    const PlacedPose start = bodies_[gripped].pose;
    if (!tryGroup(gripped, moved(start, way, 1.0, 1.0))) {
      tryParts([&](double part) { return tryGroup(gripped, moved(start, way, part, 0.0)); });
      const PlacedPose there = bodies_[gripped].pose;
      tryParts([&](double part) { return tryGroup(gripped, moved(there, way, 0.0, part)); });
    }
  }
}

/// Mean of the ways that each gripper alone would give the gripped body; `heading` is the turn.
planar::PlanarPose Kinematics2d::wayOfGroup(BodyIndex gripped, double dt) const {
  planar::PlanarPose sum;
  int count = 0;
  for (BodyIndex index = motion(gripped).gripped_by; index != kNoBody; index = motion(index).next_gripper) {
    const Body& body = bodies_[index];
    const PlacedPose target = planar::integrate(body.pose, body.velocity, body.turn_rate, dt);
    const PlacedPose carried = carriedPose(target, motion(index).place_of_gripped);
    sum.position += carried.position - bodies_[gripped].pose.position;
    sum.heading += body.turn_rate * dt;
    ++count;
  }
  return {sum.position / count, sum.heading / count};
}

/// Moves a group to a pose of its gripped body, if all of the group have room there. @return whether it has moved
bool Kinematics2d::tryGroup(BodyIndex gripped, const PlacedPose& pose) {
  Clearance unused;
  unused.look_ahead = 0.0;
  bool is_free = isFree(gripped, pose, unused, all_);
  for (BodyIndex index = motion(gripped).gripped_by; is_free && index != kNoBody; index = motion(index).next_gripper) {
    unused.look_ahead = 0.0;
    is_free = isFree(index, gripperPose(pose, motion(index).place_of_gripped), unused, all_);
  }
  if (!is_free) {
    return false;
  }
  bodies_.setPose(gripped, pose);
  for (BodyIndex index = motion(gripped).gripped_by; index != kNoBody; index = motion(index).next_gripper) {
    bodies_.setPose(index, gripperPose(pose, motion(index).place_of_gripped));
    clearance(index).free_until = -1.0;  // as for a single gripper
  }
  return true;
}

}  // namespace swarmanoid::kinematics2d

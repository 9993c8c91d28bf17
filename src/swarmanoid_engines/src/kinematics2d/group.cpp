// Phase `move`: what several robots hold goes the mean of their ways, and they go along.
#include <algorithm>
#include <cmath>

#include "kinematics2d/kinematics2d.hpp"
#include "kinematics2d/try_parts.hpp"
#include "swarmanoid_interface/angle.hpp"

namespace swarmanoid::kinematics2d {
namespace {

/// Where a gripper is, from where it has what it grips.
PlacedPose gripperPose(const PlacedPose& gripped, const planar::PlanarPose& place) {
  const PlacedPose gripper = PlacedPose::at(gripped.position, wrapAngle(gripped.heading - place.heading));
  return PlacedPose::at(gripped.position - gripper.rotated(place.position), gripper.heading);
}

PlacedPose moved(const PlacedPose& start, const planar::PlanarPose& way, double part, double turned) {
  return PlacedPose::at(start.position + part * way.position, wrapAngle(start.heading + turned * way.heading));
}

}  // namespace

/// @return how fast anything of a group goes at most: the mean of the ways that its grippers would give to what they
/// hold, and around that by the mean of their turns [m/s]
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

/// In pieces, as a body that moves alone, each as far as all have room.
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
  const double way_of_farthest = whole.position.norm() + arm * std::abs(whole.heading);  // they swing around it
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

/// The mean of where each gripper alone would take what they hold; `heading` is the turn.
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

/// @return whether all of the group have room with what they hold in that pose; then they are there
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
    clearance(index).free_until = -1.0;  // as where one carries alone
  }
  return true;
}

}  // namespace swarmanoid::kinematics2d

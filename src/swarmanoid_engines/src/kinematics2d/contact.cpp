// Phase `move`: what a body does that would overlap another.
#include <algorithm>

#include "kinematics2d/kinematics2d.hpp"
#include "kinematics2d/try_parts.hpp"

namespace swarmanoid::kinematics2d {
namespace {

constexpr double kMostPush = 0.005;  // m, beyond the way of the step: a nose that turns at a wall needs less
constexpr int kPushes = 6;           // of one contact after the other; two walls at a right angle need two

}  // namespace

/// As far as it can, in a time in which it does not jump through anything.
void Kinematics2d::movePiece(BodyIndex index, double dt) {
  const Body& body = bodies_[index];
  const PlacedPose target = planar::integrate(body.pose, body.velocity, body.turn_rate, dt);
  if (tryPose(index, target) || tryPushedOut(index, target)) {
    return;
  }
  const PlacedPose start = body.pose;
  const Eigen::Vector2d way = target.position - start.position;
  if (!way.isZero(0.0)) {
    tryParts([&](double part) {
      PlacedPose pose = start;
      pose.position += part * way;
      return tryPose(index, pose);
    });
  }
  if (body.turn_rate != 0.0) {
    const double turn = body.turn_rate * dt;
    const auto turned = [&](double part) {
      return PlacedPose::at(body.pose.position, planar::wrapAngle(start.heading + part * turn));
    };
    if (!tryPose(index, turned(1.0))) {
      tryParts([&](double part) {
        const PlacedPose pose = turned(part);
        return tryPose(index, pose) || tryPushedOut(index, pose);
      });
    }
  }
}

/// Moves the target out of what it overlaps, one contact after the other. @return whether that has led to a free pose
bool Kinematics2d::tryPushedOut(BodyIndex index, const PlacedPose& target) {
  const double most = (target.position - bodies_[index].pose.position).norm() + kMostPush;
  PlacedPose pose = target;
  for (int i = 0; i < kPushes; ++i) {
    const planar::Penetration deepest = deepestOverlap(index, pose);
    if (deepest.depth <= planar::kContactTolerance) {
      return tryPose(index, pose);
    }
    pose.position += deepest.depth * deepest.normal;
    if ((pose.position - target.position).norm() > most) {
      return false;
    }
  }
  return tryPose(index, pose);
}

/// Of a body and what it grips.
planar::Penetration Kinematics2d::deepestOverlap(BodyIndex index, const PlacedPose& pose) {
  const BodyIndex gripped = motion(index).gripped;
  planar::Penetration deepest = deepestOverlapOf(index, pose, gripped);
  const planar::Turret* turret = gripped == kNoBody ? nullptr : bodies_.findTurret(index);
  if (gripped == kNoBody || (turret != nullptr && turret->told->mode == FootbotTurret::Mode::kPassive)) {
    return deepest;  // what trails behind is not where the pose alone would put it
  }
  const planar::Penetration of_gripped =
      deepestOverlapOf(gripped, carriedPose(pose, motion(gripped).place_in_gripper), index);
  return of_gripped.depth > deepest.depth ? of_gripped : deepest;
}

/// @param partner what it holds, or is held by: never in its way
planar::Penetration Kinematics2d::deepestOverlapOf(BodyIndex index, const PlacedPose& pose, BodyIndex partner) {
  const Body& body = bodies_[index];
  planar::Penetration deepest;
  bodies_.visitNear(pose.position, body.model->radius, [&](BodyIndex other_index) {
    if (other_index == index || other_index == partner) {
      return true;
    }
    const planar::Penetration found =
        planar::deepestPenetration(*body.model, pose, body.along, bodies_[other_index], relative_shapes_);
    if (found.depth > deepest.depth && isHindering(index, pose, bodies_[other_index])) {
      deepest = found;
    }
    return true;
  });
  return deepest;
}

/// Clearances count on nobody moving farther than a stride in a step: who was pushed out may have.
void Kinematics2d::countDetour(double moved) {
  const double detour = moved - stride_;
  if (detour > detour_) {
    travelled_ += detour - detour_;
    detour_ = detour;
  }
}

}  // namespace swarmanoid::kinematics2d

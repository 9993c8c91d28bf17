// Phase `move`: what a body does that would overlap another.
#include <algorithm>
#include <cmath>

#include "kinematics2d/kinematics2d.hpp"
#include "kinematics2d/try_parts.hpp"

namespace swarmanoid::kinematics2d {
namespace {

constexpr double kMostPush = 0.005;  // m, beyond the way of the step: a nose that turns at a wall needs less
constexpr int kPushes = 24;          // of one contact after the other; two walls at a right angle need two
constexpr double kWedgeSkin = 1e-6;  // m: between contacts at other angles, pushes end that only come nearer and nearer

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
    const std::vector<planar::Penetration>& contacts = findContacts(index, pose);
    if (contacts.empty()) {
      return tryPose(index, pose);
    }
    const planar::Penetration& deepest = *std::max_element(
        contacts.begin(), contacts.end(), [](const auto& left, const auto& right) { return left.depth < right.depth; });
    constexpr int kExactPushes = 2;
    pose.position += (deepest.depth + (i < kExactPushes ? 0.0 : kWedgeSkin)) * deepest.normal;
    if ((pose.position - target.position).norm() > most) {
      return false;
    }
  }
  return tryPose(index, pose);
}

/// All that hinders a body, or what it grips, from being there: with each other body the deepest overlap.
const std::vector<planar::Penetration>& Kinematics2d::findContacts(BodyIndex index, const PlacedPose& pose) {
  contacts_.clear();
  const BodyIndex gripped = motion(index).gripped;
  addContacts(index, pose, gripped);
  const planar::Turret* turret = gripped == kNoBody ? nullptr : bodies_.findTurret(index);
  const bool is_trailing = turret != nullptr && turret->told->mode == FootbotTurret::Mode::kPassive;
  if (gripped != kNoBody && !is_trailing) {  // what trails behind is not where the pose alone would put it
    addContacts(gripped, carriedPose(pose, motion(gripped).place_in_gripper), index);
  }
  return contacts_;
}

/// @param partner what it holds, or is held by: never in its way
void Kinematics2d::addContacts(BodyIndex index, const PlacedPose& pose, BodyIndex partner) {
  const Body& body = bodies_[index];
  bodies_.visitNear(pose.position, body.model->radius, [&](BodyIndex other_index) {
    const Body& other = bodies_[other_index];
    if (other_index != index && other_index != partner) {
      const auto found = planar::deepestPenetration(*body.model, pose, body.along, other, relative_shapes_);
      if (found.depth > planar::kContactTolerance && isHindering(index, pose, other)) {
        contacts_.push_back(found);
      }
    }
    return true;
  });
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

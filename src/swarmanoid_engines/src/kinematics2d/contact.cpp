// Phase `move`: response of a body that would overlap another.
#include <algorithm>
#include <cmath>
#include <optional>

#include "kinematics2d/kinematics2d.hpp"
#include "kinematics2d/try_parts.hpp"
#include "swarmanoid_interface/angle.hpp"

namespace swarmanoid::kinematics2d {
namespace {

constexpr double kSkin = 1e-6;  // m: gap left where more than two contacts, or curved ones, meet

/// Displacement out of a contact that does not lead back into the contact before: along the surface of that one if the
/// normals oppose each other.
Eigen::Vector2d wayOut(const planar::Penetration& contact, const std::optional<Eigen::Vector2d>& normal_before) {
  if (!normal_before || normal_before->dot(contact.normal) >= 0.0) {
    return contact.depth * contact.normal;
  }
  Eigen::Vector2d along(-normal_before->y(), normal_before->x());
  along *= along.dot(contact.normal) < 0.0 ? -1.0 : 1.0;
  constexpr double kLeastSlope = 1e-6;
  return contact.depth / std::max(along.dot(contact.normal), kLeastSlope) * along;
}

}  // namespace

/// Moves the body as far as possible, in a time too short to tunnel through anything.
void Kinematics2d::movePiece(BodyIndex index, double dt, const Block& block) {
  const Body& body = bodies_[index];
  const PlacedPose target = planar::integrate(body.pose, body.velocity, body.turn_rate, dt);
  if (tryPose(index, target, block) || tryPushedOut(index, target, block)) {
    return;
  }
  const PlacedPose start = body.pose;
  const Eigen::Vector2d way = target.position - start.position;
  if (!way.isZero(0.0)) {
    tryParts([&](double part) {
      PlacedPose pose = start;
      pose.position += part * way;
      return tryPose(index, pose, block);
    });
  }
  turnPiece(index, body.turn_rate * dt, block);
}

/// Makes the whole turn, or the largest of its halves, quarters and so on that is possible; if need be, pushes the body
/// out of overlaps.
void Kinematics2d::turnPiece(BodyIndex index, double turn, const Block& block) {
  constexpr int kParts = 5;
  const PlacedPose& pose = bodies_[index].pose;
  for (int i = 0; i < kParts && turn != 0.0; ++i) {
    const PlacedPose turned = PlacedPose::at(pose.position, wrapAngle(pose.heading + turn));
    if (tryPose(index, turned, block) || tryPushedOut(index, turned, block)) {
      return;
    }
    turn *= 0.5;
  }
}

/// Pushes a blocked target pose out of its overlaps, one contact after the other. @return whether that has led to a
/// free pose, which the body then has
bool Kinematics2d::tryPushedOut(BodyIndex index, const PlacedPose& target, const Block& block) {
  constexpr int kPushes = 5;
  const double most = (target.position - bodies_[index].pose.position).norm() + kMostPush;
  PlacedPose pose = target;
  std::optional<Eigen::Vector2d> normal_before;
  for (int i = 0; i < kPushes; ++i) {
    planar::Penetration deepest = deepestContact(index, pose, block);
    if (deepest.depth <= planar::kContactTolerance) {
      return false;  // something else than a contact blocks the body
    }
    constexpr int kExactPushes = 2;
    deepest.depth += i < kExactPushes ? 0.0 : kSkin;
    pose.position += wayOut(deepest, normal_before);
    if ((pose.position - target.position).norm() > most) {
      return false;
    }
    if (tryPose(index, pose, block)) {
      return true;
    }
    normal_before = deepest.normal;
  }
  return false;
}

/// Deepest contact of a body, or of the body it grips, at a pose; depth 0 if there is none.
planar::Penetration Kinematics2d::deepestContact(BodyIndex index, const PlacedPose& pose, const Block& block) {
  Contact deepest;
  findDeeper(index, pose, block, deepest);
  const BodyIndex gripped = motion(index).gripped;
  const planar::Turret* turret = gripped == kNoBody ? nullptr : bodies_.findTurret(index);
  const bool is_trailing = turret != nullptr && turret->command.mode == JointCommand::Mode::kPassive;
  if (gripped != kNoBody && !is_trailing) {  // a trailing body is not where the pose alone would put it
    findDeeper(gripped, carriedPose(pose, motion(index).place_of_gripped), block, deepest);
  }
  return deepest.way_out;
}

/// Skips bodies connected by grips. Of equally deep contacts, the one with the older body counts, whatever the order of
/// the query.
void Kinematics2d::findDeeper(BodyIndex index, const PlacedPose& pose, const Block& block, Contact& deepest) {
  const Body& body = bodies_[index];
  const double radius = body.model->radius;
  visitNear(neighboursAt(index, pose.position, block), pose.position, radius, block, [&](BodyIndex other_index) {
    if (other_index == index || bodies_.isFartherThan(other_index, pose.position, radius) ||
        areConnected(index, other_index)) {
      return true;
    }
    const Body& other = bodies_[other_index];
    const planar::Penetration found = planar::deepestPenetration(*body.model, pose, body.along, other);
    const double depth = deepest.way_out.depth;
    if (found.depth > planar::kContactTolerance && isHindering(index, pose, other) &&
        (found.depth > depth || (found.depth == depth && other.number < deepest.with))) {
      deepest = {found, other.number};
    }
    return true;
  });
}

}  // namespace swarmanoid::kinematics2d

#include "dynamics2d/rigid_body.hpp"

#include <algorithm>
#include <cmath>

#include "swarmanoid_interface/angle.hpp"

namespace swarmanoid::dynamics2d {
namespace {

constexpr double kFloatUlp = 1.1920928955078125e-7;  // of 1, in single precision

/// What a coordinate changed by in a step: by velocity times time, without the rounding of adding a small number to a
/// large one; and by what Box2D moved it beyond that, as far as that is more than such rounding.
double change(float now, float before, double by_velocity) {
  const double beyond = static_cast<double>(now) - static_cast<double>(before) - by_velocity;
  const double rounding =
      kFloatUlp * std::max(std::abs(static_cast<double>(now)), std::abs(static_cast<double>(before)));
  return std::abs(beyond) <= rounding ? by_velocity : by_velocity + beyond;
}

}  // namespace

void RigidBody::setVelocity(const Eigen::Vector2d& linear, double angular) {
  velocity = linear;
  spin = angular;
  if (!isAlone()) {
    body->SetLinearVelocity(toUnits(linear));
    body->SetAngularVelocity(static_cast<float>(angular));
  }
}

void RigidBody::writeTransform() {
  if (!isConnected()) {
    heading = wrapAngle(heading);  // a rigid joint would take a whole turn for an error
  }
  if (isAlone()) {
    return;
  }
  body->SetTransform(toUnits(pose().position), static_cast<float>(heading));
  last_centre = body->GetWorldCenter();
  last_angle = body->GetAngle();
}

void RigidBody::readStep(double h) {
  const b2Vec2& now = body->GetWorldCenter();
  const float angle = body->GetAngle();
  const b2Vec2& moved = body->GetLinearVelocity();
  centre.x() += change(now.x, last_centre.x, moved.x * h) / kUnitsPerMetre;
  centre.y() += change(now.y, last_centre.y, moved.y * h) / kUnitsPerMetre;
  heading += change(angle, last_angle, body->GetAngularVelocity() * h);
  last_centre = now;
  last_angle = angle;
  // The floats go their own way by rounding; before it matters to contacts they are set right.
  constexpr double kApart = 1e-5;  // m, rad
  const double coarse = 2.0 * kFloatUlp * std::max(std::abs(centre.x()), std::abs(centre.y()));
  const double apart = (centre - toMetres(now)).cwiseAbs().maxCoeff();
  if (apart > std::max(kApart, coarse) || std::abs(heading - static_cast<double>(angle)) > kApart ||
      (std::abs(heading) > 2.0 * M_PI && !isConnected())) {
    writeTransform();
  }
}

planar::PlacedPose RigidBody::pose(const planar::PlacedPose& similar) const {
  planar::PlacedPose pose = planar::PlacedPose::at(centre, wrapAngle(heading), similar);
  if (!arm.isZero(0.0)) {
    pose.position -= pose.rotated(arm);
  }
  return pose;
}

}  // namespace swarmanoid::dynamics2d

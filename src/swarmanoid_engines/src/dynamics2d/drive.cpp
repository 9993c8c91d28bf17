// What drives robots that are alone: treels that push on the ground, and flight. A robot gets in each step the forces
// that bring it to the commanded velocity within that step, as far as the ground holds; a treel that slips is held back
// against its slip. In islands the same is solved together with contacts (drive_constraints.cpp).
#include <algorithm>
#include <cmath>

#include "dynamics2d/dynamics2d.hpp"
#include "dynamics2d/flight.hpp"
#include "dynamics2d/friction.hpp"
#include "swarmanoid_interface/angle.hpp"

namespace swarmanoid::dynamics2d {
namespace {

Eigen::Vector2d limited(const Eigen::Vector2d& force, double most) {
  const double squared = force.squaredNorm();
  return squared > most * most ? Eigen::Vector2d(force * (most / std::sqrt(squared))) : force;
}

/// What treels push with that cannot all do what is asked of them: each with what the ground holds, against its slip.
/// One after the other, again and again, until none changes.
/// @param velocity, turn_rate of the centre of mass, beyond what is asked for; without any push
std::array<Eigen::Vector2d, 2> slippingTreels(const RigidBody& rigid_body, Eigen::Vector2d velocity, double turn_rate,
                                              double step) {
  constexpr int kMostSweeps = 100;
  constexpr double kSettled = 1e-7;  // of the traction
  std::array<Eigen::Vector2d, 2> forces{Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero()};
  double change = 1.0;
  for (int sweep = 0; sweep < kMostSweeps && change > kSettled * rigid_body.traction; ++sweep) {
    change = 0.0;
    for (std::size_t i = 0; i < forces.size(); ++i) {
      const Eigen::Vector2d place = (i == 0 ? 0.5 : -0.5) * rigid_body.axle - rigid_body.arm;
      const Eigen::Vector2d across(-place.y(), place.x());
      const Eigen::Matrix2d yield =
          step * (Eigen::Matrix2d::Identity() / rigid_body.mass + across * across.transpose() / rigid_body.inertia);
      const Eigen::Vector2d slip = velocity + turn_rate * across;
      const Eigen::Vector2d force = coulombFriction(yield, slip - yield * forces[i], rigid_body.traction);
      const Eigen::Vector2d added = force - forces[i];
      forces[i] = force;
      velocity += step / rigid_body.mass * added;
      turn_rate += step / rigid_body.inertia * across.dot(added);
      change = std::max(change, added.norm());
    }
  }
  return forces;
}

/// @param velocity of the centre of mass at heading 0, @param spin before the step
Push treelPush(const RigidBody& rigid_body, const Eigen::Vector2d& velocity, double spin, double step) {
  const Eigen::Vector2d excess = velocity - rigid_body.centre_advance / step;
  const double turn_excess = spin - rigid_body.turn_rate;
  const Eigen::Vector2d force = -rigid_body.mass / step * excess;
  const double torque = -rigid_body.inertia / step * turn_excess;
  // both treels carry half of it, and push in opposite directions to turn
  const Eigen::Vector2d opposite =
      (torque + planar::cross(rigid_body.arm, force)) / rigid_body.track * rigid_body.ahead;
  Eigen::Vector2d left = 0.5 * force + opposite;
  Eigen::Vector2d right = 0.5 * force - opposite;
  if (std::max(left.squaredNorm(), right.squaredNorm()) > rigid_body.traction * rigid_body.traction) {
    const auto slipping = slippingTreels(rigid_body, excess, turn_excess, step);
    left = slipping[0];
    right = slipping[1];
  }
  const Eigen::Vector2d held = left + right;
  // the treels lie left and right of the origin, by half the track
  return {held, 0.5 * planar::cross(rigid_body.axle, left - right) - planar::cross(rigid_body.arm, held)};
}

/// Likewise.
Push flightPush(const RigidBody& rigid_body, const Eigen::Vector2d& velocity, double spin, double step) {
  const double most = rigid_body.inertia * kFlightTurnAcceleration;
  return {limited(rigid_body.mass / step * (rigid_body.centre_advance / step - velocity),
                  rigid_body.mass * kFlightAcceleration),
          std::clamp(rigid_body.inertia / step * (rigid_body.turn_rate - spin), -most, most)};
}

Push pushOf(const RigidBody& rigid_body, const Eigen::Vector2d& velocity, double spin, double step) {
  return rigid_body.drive == Drive::kTreels ? treelPush(rigid_body, velocity, spin, step)
                                            : flightPush(rigid_body, velocity, spin, step);
}

}  // namespace

void Dynamics2d::prepareDrive(BodyIndex index, double step) {
  const Body& body = bodies_[index];
  RigidBody& rigid_body = rigid(index);
  const planar::PlacedPose end = planar::integrate(planar::PlacedPose{}, body.velocity, body.turn_rate, step);
  rigid_body.centre_advance = end.position + end.rotated(rigid_body.arm) - rigid_body.arm;
  rigid_body.turn_rate = body.turn_rate;
  rigid_body.drive = body.is_wheeled ? Drive::kTreels : Drive::kFlight;
  if (body.is_wheeled) {
    const PlanarModel& model = *body.model;
    rigid_body.ahead = model.ahead;
    rigid_body.axle = body.entity->wheels->separation * model.left;
    rigid_body.track = body.entity->wheels->separation * planar::cross(model.left, model.ahead);
    rigid_body.traction = 0.5 * material_.treel_friction * rigid_body.mass * material_.gravity;
  }
}

void Dynamics2d::driveAlone(BodyIndex index, double step, int steps) {
  RigidBody& rigid_body = rigid(index);
  planar::PlacedPose pose = planar::PlacedPose::at(rigid_body.centre, rigid_body.heading, bodies_[index].pose);
  for (int i = 0; i < steps; ++i) {
    const Push push = pushOf(rigid_body, pose.unrotated(rigid_body.velocity), rigid_body.spin, step);
    rigid_body.last_push = pose.rotated(push.force);
    rigid_body.velocity += step / rigid_body.mass * rigid_body.last_push;
    rigid_body.spin += step / rigid_body.inertia * push.torque;
    rigid_body.centre += step * rigid_body.velocity;
    rigid_body.heading = wrapAngle(rigid_body.heading + step * rigid_body.spin);
    pose = planar::PlacedPose::at(rigid_body.centre, rigid_body.heading, pose);
  }
}

}  // namespace swarmanoid::dynamics2d

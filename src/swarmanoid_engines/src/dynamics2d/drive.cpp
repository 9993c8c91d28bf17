// Drives of robots that are alone: treels that push on the ground, and flight. In each step a robot gets the forces
// that bring it to the commanded velocity within that step, as far as the ground holds; the friction of a slipping
// treel opposes its slip. In islands the same is solved together with contacts (drive_constraints.cpp).
#include <algorithm>
#include <cmath>

#include "dynamics2d/dynamics2d.hpp"
#include "dynamics2d/flight.hpp"
#include "swarmanoid_interface/angle.hpp"

namespace swarmanoid::dynamics2d {
namespace {

Eigen::Vector2d limited(const Eigen::Vector2d& force, double most) {
  const double squared = force.squaredNorm();
  return squared > most * most ? Eigen::Vector2d(force * (most / std::sqrt(squared))) : force;
}

/// @param velocity of the centre of mass at heading 0 @param spin both before the step
Push treelPush(const RigidBody& rigid_body, const Eigen::Vector2d& velocity, double spin, double step) {
  PlanarTwist excess;
  excess << velocity - rigid_body.centre_advance / step, spin - rigid_body.turn_rate;
  constexpr int kMostSweeps = 100;
  const TreelImpulses nothing{Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero()};
  const TreelImpulses impulses = treelImpulses(rigid_body.treels, rigid_body.mass, rigid_body.inertia, excess,
                                               rigid_body.traction * step, nothing, kMostSweeps);
  const Eigen::Vector3d sum = sumOf(rigid_body.treels, impulses) / step;
  return {sum.head<2>(), sum.z()};
}

/// Parameters as above.
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
    const Eigen::Vector2d axle = body.entity->wheels->separation * model.left;
    rigid_body.treels = {0.5 * axle - rigid_body.arm, -0.5 * axle - rigid_body.arm, model.ahead,
                         planar::cross(axle, model.ahead)};
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

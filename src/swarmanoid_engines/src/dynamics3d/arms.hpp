/// The jointed links of a robot: rigid bodies on hinges that motors turn to the angles or with the speeds that the
/// robot commands, with no more speed and torque than the model's joints have.
///
/// Motors keep to the range of their joints, whatever is commanded. Just beyond it there are stops, for loads that the
/// motors do not hold.
///
/// Links do not collide with the rest of their own robot.
#pragma once

#include "dynamics3d/body.hpp"

namespace swarmanoid::dynamics3d {

/// Makes rigid bodies and hinges for all of the model's joints. Masses are still to be given.
/// @pre body.rigid is there, body.own too
std::vector<Link> makeLinks(dWorldID world, const Body& body);

/// Puts the links where body.pose and the joints say. @param joints none: all are zero
void placeLinks(Body& body, Span<const JointState> joints);
/// Gives them the velocities that the body's twist and the joints' speeds add up to. @param joints none: none turns
void moveLinks(Body& body, const Twist& twist, Span<const JointState> joints);

/// For a body without links: turns its solids as the joints are.
void turnSolids(Body& body, Span<const JointState> joints);

/// Sets the motors for a step [s].
void driveLinks(Body& body);
/// Writes angles, speeds and efforts.
void readLinks(const Body& body, Span<JointState> joints);

}  // namespace swarmanoid::dynamics3d

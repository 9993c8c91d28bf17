/// The jointed links of a robot: rigid bodies on hinges. Motors turn the hinges to the commanded angles, or with the
/// commanded speeds, within the speed and torque limits of the model's joints.
///
/// Motors keep to the range of their joints, whatever the command. Just beyond it there are stops, for loads that the
/// motors do not hold.
///
/// Links do not collide with the rest of their own robot.
#pragma once

#include "dynamics3d/body.hpp"

namespace swarmanoid::dynamics3d {

/// Makes rigid bodies and hinges for all of the model's joints. The caller must set the masses.
/// @pre body.rigid and body.own are set
std::vector<Link> makeLinks(dWorldID world, const Body& body);

/// Places the links by body.pose and the joints. @param joints empty: all are at zero
void placeLinks(Body& body, Span<const JointState> joints);
/// Sets the links' velocities from the body's twist and the joints' speeds. @param joints empty: none turns
void moveLinks(Body& body, const Twist& twist, Span<const JointState> joints);

/// For a body without links: turns its solids to the joints' angles.
void turnSolids(Body& body, Span<const JointState> joints);

/// Sets the motors for a step [s].
void driveLinks(Body& body);
/// Writes angles, speeds and efforts.
void readLinks(const Body& body, Span<JointState> joints);

}  // namespace swarmanoid::dynamics3d

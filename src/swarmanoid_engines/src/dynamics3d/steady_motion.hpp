/// Bodies on level ground in steady motion or at rest: ODE would find the same forces for them in every step.
///
/// In a swarm those are nearly all robots. A body whose velocities, in its own frame, have stayed the same for some
/// steps without neighbours, and whose commands are the same, moves along an arc: `moveOn` continues ODE's steps in one
/// go. The body is left out of ODE for a tick, and taken in again in the step in which the box around its way meets
/// that of another body.
#pragma once

#include "dynamics3d/body.hpp"

namespace swarmanoid::dynamics3d {

/// Call after a step in ODE: records whether the body moved as in the step before. @param step [s]
void noteStep(Body& body, double step);

/// Whether the body will move as in the last steps if it meets no other body and the ground under it is level. Call
/// after its commands of the tick were read.
bool movesSteadily(const Body& body);

/// Box around all poses that the body may have in a tick. @param box around it at the start of the tick @param tick [s]
Eigen::AlignedBox3d boxAroundWay(const Body& body, const Eigen::AlignedBox3d& box, double tick);

/// Moves the body by a number of steps. @pre it moves steadily @param step [s]
void moveOn(Body& body, int steps, double step);

}  // namespace swarmanoid::dynamics3d

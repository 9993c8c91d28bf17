/// Bodies on level ground that go on as they do, or stand: ODE would find the same forces for them in every step.
///
/// In a swarm those are nearly all robots. A body whose velocities, in its own frame, have stayed the same for some
/// steps with nobody near, and whose commands are the same, moves along an arc: `moveOn` continues what ODE's steps do,
/// in one go. It is left out of ODE for a tick, and taken in again in the step in which the box around its way meets
/// that of another.
#pragma once

#include "dynamics3d/body.hpp"

namespace swarmanoid::dynamics3d {

/// After a step in ODE: whether the body moved as in the step before. @param step [s]
void noteStep(Body& body, double step);

/// Whether it will move as it did in the last steps if nothing meets it, the ground under it being level. After its
/// commands of the tick were read.
bool movesSteadily(const Body& body);

/// Around all places where the body may be in a tick. @param box around it as the tick begins @param tick [s]
Eigen::AlignedBox3d boxAroundWay(const Body& body, const Eigen::AlignedBox3d& box, double tick);

/// Moves it on by so many steps. @pre it moves steadily @param step [s]
void moveOn(Body& body, int steps, double step);

}  // namespace swarmanoid::dynamics3d

/// Steps of robots that hang on a taut rope, so that a swing keeps its energy.
///
/// ODE turns bodies by a rule that takes or gives some per cent of their energy a minute, and closes gaps of hinges by
/// a fifth in each step, so that forces on an arm lag behind where the body turns. For robots that hang, the gyroscopic
/// torque is that of the midpoint rule in the rigid body's own frame; and a step is solved again until the hinges are
/// closed at its end, within 2 um (the SHAKE scheme, as for ropes). ODE has no place for that correction: the link is
/// displaced during a solution by so much that ODE closes the gap which the step opens.
#pragma once

#include "dynamics3d/body.hpp"

namespace swarmanoid::dynamics3d {

/// Before each solution of a step, while rope.feedback is that of the solution before. @pre robot.holding
void prepareHanging(Body& robot, double error_reduction);
/// After each solution of a step. @pre prepareHanging
void finishHanging(Body& robot);
/// After finishHanging: whether the hinges of a robot that hangs are closed. If not, the next solution corrects that.
bool areHingesKept(Body& robot);

}  // namespace swarmanoid::dynamics3d

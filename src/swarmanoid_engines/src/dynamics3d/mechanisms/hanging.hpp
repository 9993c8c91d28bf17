/// Steps of robots that hang on a taut rope, which keep the energy of a swing.
///
/// ODE's integration of rotation adds or removes some per cent of a body's energy a minute. ODE also closes only a
/// fifth of a hinge's gap in each step, so that forces on an arm lag behind the body's rotation. For hanging robots,
/// the gyroscopic torque is that of the midpoint rule in the rigid body's own frame; and a step is solved again until
/// the hinges are closed at its end, within 2 um (the SHAKE scheme, as for ropes). ODE has no input for that
/// correction: during a solution, the link is displaced so that ODE closes the gap which the step opens.
#pragma once

#include "dynamics3d/body.hpp"

namespace swarmanoid::dynamics3d {

/// Call before each solution of a step, while rope.feedback is that of the previous solution. @pre robot.holding
void prepareHanging(Body& robot, double error_reduction);
/// Call after each solution of a step. @pre prepareHanging
void finishHanging(Body& robot);
/// Call after finishHanging. Returns whether the hinges of a hanging robot are closed; if not, the next solution
/// corrects that.
bool areHingesKept(Body& robot);

}  // namespace swarmanoid::dynamics3d

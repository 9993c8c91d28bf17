/// Flight of a robot: one thrust along body z and three torques, as from its four rotors, and drag.
///
/// An inner loop does the work of the flight computer: it tilts the body until the thrust gives the wanted
/// acceleration. An outer loop follows the commanded velocity and, by its integral, the position that the robot would
/// have had it flown as commanded: so it hovers at its height in spite of drag and collisions. Velocities are those of
/// the centre of mass, in the upright frame with the body's heading.
#pragma once

#include "dynamics3d/body.hpp"

namespace swarmanoid::dynamics3d {

/// Adds the forces of one step. @pre its flight is commanded @param gravity [m/s2]; @param step [s]
void fly(Body& robot, double gravity, double step);

}  // namespace swarmanoid::dynamics3d

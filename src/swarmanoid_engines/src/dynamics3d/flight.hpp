/// How a robot flies: one thrust along body z and three torques, as its four rotors make them, and drag.
///
/// An inner loop keeps what its flight computer keeps: it tilts the body until the thrust gives the wanted
/// acceleration. An outer loop follows the commanded velocity and, by its integral, the place where the robot would be
/// had it flown as commanded: so it hovers at its height whatever drag and collisions do. Velocities are those of the
/// centre of mass, in the frame that has the body's heading and stands upright.
#pragma once

#include "dynamics3d/body.hpp"

namespace swarmanoid::dynamics3d {

/// Adds the forces of one step. @pre its flight is commanded @param gravity [m/s2]; @param step [s]
void fly(Body& robot, double gravity, double step);

}  // namespace swarmanoid::dynamics3d

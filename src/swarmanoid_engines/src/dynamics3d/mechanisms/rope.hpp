/// The rope of a robot: a massless line that keeps the launcher within its length of the magnet's anchor. It pulls, and
/// never pushes.
///
/// In ODE it is a contact whose normal is the rope's direction: it acts between the rope's ends as contacts do between
/// surfaces, with the opposite sign. So it is solved together with all other contacts, by the exact solver exactly. Its
/// tension acts along the direction at the start of the step, and leaves its ends its length apart at the end: a swing
/// then keeps its energy at any time step (the SHAKE scheme; velocities are those of the middle of the step). ODE
/// solves for velocities, and the launcher moves along an arc when the body turns: so a step is solved again until its
/// ends are its length apart, within 1 um (hanging.hpp for the body's own rotation). A rope that becomes taut absorbs
/// the speed along it, without rebound.
#pragma once

#include "dynamics3d/body.hpp"

namespace swarmanoid::dynamics3d {

// Ropes are given by their index in the holders of the robot's model.

/// Current position in W at which the rope leaves the robot.
Eigen::Vector3d launcherOf(const Body& robot, std::size_t rope);

/// Call before each step: sets the winding speed of the rope. @pre the rope holds something
void windRope(Body& robot, std::size_t rope, double step);
/// Call before each step: brakes the hanging body across the rope, by `drag` for each m/s of its launcher [N s/m].
/// @pre the rope holds something
void dragRope(Body& robot, std::size_t rope, double drag);
/// Makes the rope's joint of a step. @pre it holds something
dJointID makeRopeJoint(dWorldID world, dJointGroupID joints, Body& robot, std::size_t rope, double step);
/// Call after a step was solved. Returns whether the ends of the rope are no farther apart than its length, and exactly
/// that far apart if it pulls. If not, its next joint corrects that; a correction is also the first guess of the
/// following steps.
/// @pre it holds something
bool isRopeKept(Body& robot, std::size_t rope, double step);
/// Call after each step: updates tension and length. @pre it holds something
/// @param share of the step in the filtered tension
void feelRope(Rope& rope, double step, double share, double strength);

/// Calls visit(index) for each rope of a robot that holds something.
template <class Visit>
void visitRopes(Body& robot, Visit visit) {
  if (robot.holding == nullptr) {
    return;
  }
  for (std::size_t i = 0; i < robot.holding->ropes.size(); ++i) {
    if (robot.holding->ropes[i].held != nullptr) {
      visit(i);
    }
  }
}

}  // namespace swarmanoid::dynamics3d

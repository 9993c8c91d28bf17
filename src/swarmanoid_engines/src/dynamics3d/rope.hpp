/// The rope of a robot: a line without mass that keeps the launcher within its length of where its magnet holds. It
/// pulls, and never pushes.
///
/// It is a contact in ODE whose normal is the rope's direction: what contacts do between surfaces, the rope does
/// between its ends, with the sign turned. So it is solved together with all other contacts, in the exact solver
/// exactly. Its tension acts along the direction at the start of the step and is what leaves its ends its length apart
/// at the end: a swing then keeps its energy, whatever the step is (the SHAKE scheme; velocities are those of the
/// middle of the step). ODE solves for velocities, and the launcher goes along an arc where the body turns: so a step
/// is solved again until the ends are the length apart, within 1 um (hanging.hpp for the body's own turning). A rope
/// that becomes taut takes the speed along it, and gives nothing back.
#pragma once

#include "dynamics3d/body.hpp"

namespace swarmanoid::dynamics3d {

// A rope is an index of the holders of the robot's model.

/// Where the rope leaves the robot, in W, now.
Eigen::Vector3d launcherOf(const Body& robot, std::size_t rope);

/// Before each step: how fast the rope is wound in it. @pre the rope holds something
void windRope(Body& robot, std::size_t rope, double step);
/// Before each step: brakes the body that hangs on it, across the rope, by `drag` for each m/s of its launcher [N s/m].
/// @pre the rope holds something
void dragRope(Body& robot, std::size_t rope, double drag);
/// Makes the rope's joint of a step. @pre it holds something
dJointID makeRopeJoint(dWorldID world, dJointGroupID joints, Body& robot, std::size_t rope, double step);
/// After a step was solved: whether the ends of the rope are no farther apart than its length, and its length if it
/// pulls. If not, its next joint corrects that; a correction also serves as the first guess of the steps that follow.
/// @pre it holds something
bool isRopeKept(Body& robot, std::size_t rope, double step);
/// After each step: how strong it was pulled, and how long it is now. @pre it holds something
/// @param share of the step in the lasting tension
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

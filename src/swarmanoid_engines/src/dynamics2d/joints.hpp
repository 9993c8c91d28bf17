/// Box2D's joints where ours solve their own equations otherwise: treels whose friction opposes their slip, and turrets
/// whose motors feel all of their load.
///
/// Box2D makes joints of its own kinds only, calls them by their virtual functions, and frees them by the size of the
/// kind. Ours have the same members and take the place of what Box2D has made.
#pragma once

#include <box2d/b2_friction_joint.h>
#include <box2d/b2_revolute_joint.h>
#include <box2d/b2_world.h>

#include <new>

namespace swarmanoid::dynamics2d {

/// The joint between a treel and its belt. Box2D's own friction joint solves both directions, each with its effective
/// mass, and then shortens the impulse: of a treel that slips beside the centre of mass the friction points up to 20
/// degrees past the slip, which pushes the robot aside. @pre body A, the belt, is moved by nothing but itself
class TreelJoint final : public b2FrictionJoint {
 public:
  explicit TreelJoint(const b2FrictionJoint& other) : b2FrictionJoint(other) {}

 protected:
  void SolveVelocityConstraints(const b2SolverData& data) override;
};

/// The joint between a turret and its load. Box2D's own revolute joint turns the motor against the load's inertia about
/// its own centre, and then lets the pivot bring the rest of it along, which for a light load takes more iterations
/// than there are: it came to 1.2 times the commanded speed. Motor and pivot are solved together here.
class TurretJoint final : public b2RevoluteJoint {
 public:
  explicit TurretJoint(const b2RevoluteJoint& other) : b2RevoluteJoint(other) {}

 protected:
  void SolveVelocityConstraints(const b2SolverData& data) override;
};

/// Makes a joint of ours in the memory of a joint that Box2D has made. @return the joint, as Box2D's type
template <class Ours, class Theirs, class Definition>
Theirs* makeJoint(b2World& world, const Definition& definition) {
  static_assert(sizeof(Ours) == sizeof(Theirs) && alignof(Ours) == alignof(Theirs));
  auto* made = static_cast<Theirs*>(world.CreateJoint(&definition));
  const Ours ours(*made);
  return new (made) Ours(ours);
}

}  // namespace swarmanoid::dynamics2d

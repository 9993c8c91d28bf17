/// Treels as drives of a robot: a treel pushes the surface under a wheel backwards, like a moving belt, with no more
/// than Coulomb friction; beyond that it slips. The same friction holds sideways.
///
/// The wheels' balls carry the robot. The balls before and behind them are soft: on level ground they carry almost
/// nothing, so that they do not hinder turning; otherwise they carry the load that would tip the robot. They drive as
/// the wheels do, since the belt runs around them all.
#pragma once

#include "dynamics3d/body.hpp"

namespace swarmanoid::dynamics3d {

/// Motors need some time to reach the commanded speed; the robot would rear otherwise.
constexpr double kTreelAcceleration = 3.0;  // m/s2

/// Sets the treels to the speed of the robot. @param twist of B, in W
void takeSpeed(Body& robot, const Twist& twist);

/// Adds the distance that the treels have run in the tick to the turns of the wheels.
void turnWheels(const Body& robot, WheelTurns& turns);

/// Moves the treels' speeds towards the commanded speeds of the wheels, and lets them run for a step. @param step [s]
void followCommand(Body& robot, double step);

/// Whether the treels run at their commanded speeds.
bool runsAsCommanded(const Body& robot);

/// Sets a contact's friction and motion; a ball that touches sideways keeps an ordinary contact.
/// @param solid of the robot, which is the contact's first body
void driveContact(const Body& robot, const Solid& solid, const Settings& settings, double step, dContact& contact);

}  // namespace swarmanoid::dynamics3d

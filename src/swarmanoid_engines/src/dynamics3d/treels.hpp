/// How treels drive a robot: what stands under a wheel is pushed backwards, as by a moving belt, with no more
/// than Coulomb's friction; beyond, the treel slips. Sideways the same friction holds.
///
/// The wheels' balls carry the robot. The balls before and behind them are soft: on level ground they carry next to
/// nothing, so that they do not hinder turning, and otherwise what would tip the robot. They drive as the wheels do,
/// since the belt runs around them all.
#pragma once

#include "dynamics3d/body.hpp"

namespace swarmanoid::dynamics3d {

/// Motors need some time to reach the commanded speed; the robot would rear otherwise.
constexpr double kTreelAcceleration = 3.0;  // m/s2

/// Lets the treels run as fast as the robot moves. @param twist of B, in W
void takeSpeed(Body& robot, const Twist& twist);

/// Adds what the treels have run in the tick to the turns of the wheels.
void turnWheels(const Body& robot, WheelTurns& turns);

/// Brings the treels' speeds nearer to the commanded speeds of the wheels, and lets them run for a step. @param step
/// [s]
void followCommand(Body& robot, double step);

/// Whether the treels are as fast as they are commanded to be.
bool runsAsCommanded(const Body& robot);

/// Sets a contact's friction and motion; if the ball touches sideways, it stays a contact as any other.
/// @param solid of the robot, which is the contact's first body
void driveContact(const Body& robot, const Solid& solid, const Settings& settings, double step, dContact& contact);

}  // namespace swarmanoid::dynamics3d

/// Settings of a dynamic engine from an experiment file, and its constants. SI units.
#pragma once

namespace swarmanoid::dynamics3d {

struct Settings {
  enum class Solver { kExact, kIterative };

  int subclock = 10;               ///< steps a tick
  Solver solver = Solver::kExact;  ///< dWorldStep or dWorldQuickStep
  int iterations = 50;             ///< of the iterative solver in each step
  double gravity = 9.81;           ///< downwards [m/s2]
  bool has_ground = true;          ///< a level plane that carries bodies
  double ground_height = 0.0;      ///< [m]
  double friction = 0.5;           ///< of all surfaces but the treels' (Coulomb)
  double treel_friction = 0.9;     ///< of treels on any surface (Coulomb)
  double restitution = 0.0;        ///< part of the speed of an impact that comes back
  double grip_strength = 50.0;     ///< force that opens a gripper [N]
  double suction_strength = 30.0;  ///< force that pulls a hand off its surface [N]
  double rope_strength = 80.0;     ///< force that pulls a rope's magnet off [N]
  double rope_drag = 0.0;          ///< of a hanging body, across its rope [N s/m]
  double magnet_strength = 60.0;   ///< force that pulls a robot's magnet off [N]
};

/// In longer steps bodies sink into each other, and through the ground.
constexpr double kLongestStep = 0.01;  // s

/// Surfaces nearer than this get contacts in a step, so that they meet without penetration: a resting body keeps its
/// contacts although it rocks a little, and a body at a footbot's speed stops at the surface.
constexpr double kMargin = 2e-3;  // m

constexpr double kErrorReduction = 0.2;  // of a depth or a joint's gap, in each step
constexpr double kSoftness = 1e-6;       // m/s per N: makes forces unique where many contacts share a load

/// Number of steps until placed bodies stand: in these, contacts are as stiff as ever, but not damped.
constexpr int kSettlingSteps = 2;

}  // namespace swarmanoid::dynamics3d

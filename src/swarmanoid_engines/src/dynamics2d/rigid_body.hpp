/// One body of dynamics2d: its mass, its motion, what drives it and what it holds. All of it is in double precision.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "dynamics2d/contact_shape.hpp"
#include "dynamics2d/support.hpp"
#include "dynamics2d/treels.hpp"
#include "planar/bodies.hpp"

namespace swarmanoid::dynamics2d {

using planar::Body;
using planar::BodyIndex;
using planar::kNoBody;
using planar::PlanarModel;

/// What the gripper of a body holds.
struct Grip {
  BodyIndex gripped = kNoBody;  ///< kNoBody: nothing
  bool is_torn = false;         ///< in this tick; the structural tree learns it in `connect`
  bool must_open = false;       ///< was torn off: grips again only after it was opened
  bool has_turret = false;      ///< the held body turns about the robot's origin; otherwise it is held rigidly
  Eigen::Vector2d on_gripper = Eigen::Vector2d::Zero();  ///< the pivot, from the centre of mass, at heading 0 [m]
  Eigen::Vector2d on_held = Eigen::Vector2d::Zero();     ///< the same for the held body
  double angle = 0.0;                                    ///< heading of the held body minus the gripper's [rad]
  Eigen::Vector2d impulse = Eigen::Vector2d::Zero();     ///< since the grip was last looked at [N s]

  bool isHolding() const { return gripped != kNoBody && !is_torn; }
};

/// What pushes a body by itself.
enum class Drive : std::uint8_t { kNone, kTreels, kFlight };

/// What drives a body in a step.
struct Push {
  Eigen::Vector2d force = Eigen::Vector2d::Zero();  ///< at heading 0 [N]
  double torque = 0.0;                              ///< about the centre of mass [N m]
};

/// What every tick needs comes first: with many bodies, a tick costs as much as the memory that it touches.
struct RigidBody {
  bool is_fast = false;     ///< so that it looks for others, instead of others for it
  bool is_reached = false;  ///< by one that is fast, in this tick
  bool is_present = false;  ///< in an island of this tick; otherwise nothing can reach it
  double way = 0.0;         ///< that it may come in this tick [m]
  double jump = 0.0;        ///< of a mirror: from where it was to where it was put before this tick [m]
  double free_until = 0.0;  ///< nothing slow can reach it until travelled_ (see Dynamics2d) is as large

  Eigen::Vector2d velocity = Eigen::Vector2d::Zero();  ///< of the centre of mass, in the plane [m/s]
  double spin = 0.0;                                   ///< [rad/s]
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();    ///< of mass, in the plane [m]
  double heading = 0.0;                                ///< [rad]

  double mass = 0.0;                              ///< [kg]
  double inertia = 0.0;                           ///< about the centre of mass [kg m2]
  Eigen::Vector2d arm = Eigen::Vector2d::Zero();  ///< from the origin to the centre of mass, at heading 0 [m]

  // The motion that the drive is to make in each step of this tick, and its forces; vectors are at heading 0.
  Eigen::Vector2d centre_advance = Eigen::Vector2d::Zero();  ///< [m]
  double turn_rate = 0.0;                                    ///< [rad/s]
  Treels treels;
  double traction = 0.0;  ///< the most that a treel pushes with [N]
  Drive drive = Drive::kNone;
  int held_by = 0;  ///< grippers
  int place = -1;   ///< in its island, while that moves
  int rank = -1;    ///< among those present in this tick
  Grip grip;

  // Made when they are needed first.
  std::vector<ContactShape> shapes;
  Support support;
  std::array<Eigen::Vector2d, 2> treel_forces{Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero()};  ///< last step's [N]
  Eigen::Vector2d last_push = Eigen::Vector2d::Zero();  ///< of other drives, in the last step, in the plane [N]

  bool isConnected() const { return grip.isHolding() || held_by > 0; }
  /// Nothing moves it, and it moves nothing.
  bool isAtRest() const { return velocity.isZero(0.0) && spin == 0.0; }
  /// Where the body's origin is. @param similar it may have the same heading
  planar::PlacedPose pose(const planar::PlacedPose& similar = {}) const;
};

}  // namespace swarmanoid::dynamics2d

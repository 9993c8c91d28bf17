/// One body of dynamics2d: its mass, motion, drive and grip. All of it is in double precision.
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

/// Grip of a body on another one.
struct Grip {
  BodyIndex gripped = kNoBody;  ///< kNoBody: none
  bool is_torn = false;         ///< in this tick; `connect` updates the structural tree
  bool must_open = false;       ///< after tearing: grips again only after it was opened
  bool has_turret = false;      ///< the held body turns about the robot's origin; otherwise it is held rigidly
  Eigen::Vector2d on_gripper = Eigen::Vector2d::Zero();  ///< the pivot, from the centre of mass, at heading 0 [m]
  Eigen::Vector2d on_held = Eigen::Vector2d::Zero();     ///< the same for the held body
  double angle = 0.0;                                    ///< heading of the held body minus the gripper's [rad]
  Eigen::Vector2d impulse = Eigen::Vector2d::Zero();     ///< since the last tearGrips [N s]

  bool isHolding() const { return gripped != kNoBody && !is_torn; }
};

/// Kind of drive of a body.
enum class Drive : std::uint8_t { kNone, kTreels, kFlight };

/// Force and torque of a drive in a step.
struct Push {
  Eigen::Vector2d force = Eigen::Vector2d::Zero();  ///< at heading 0 [N]
  double torque = 0.0;                              ///< about the centre of mass [N m]
};

/// Data that every tick needs come first: with many bodies, a tick costs as much as the memory that it touches.
struct RigidBody {
  bool is_fast = false;     ///< it searches for others, instead of others for it
  bool is_reached = false;  ///< it may meet a fast body in this tick
  bool is_present = false;  ///< in an island of this tick; otherwise it moves alone
  double way = 0.0;         ///< upper bound on its motion in this tick [m]
  double jump = 0.0;        ///< of a mirror: its motion by placement before this tick [m]
  double free_until = 0.0;  ///< no slow body can reach it until travelled_ (see Dynamics2d) exceeds this

  Eigen::Vector2d velocity = Eigen::Vector2d::Zero();  ///< of the centre of mass, in the plane [m/s]
  double spin = 0.0;                                   ///< [rad/s]
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();    ///< of mass, in the plane [m]
  double heading = 0.0;                                ///< [rad]

  double mass = 0.0;                              ///< [kg]
  double inertia = 0.0;                           ///< about the centre of mass [kg m2]
  Eigen::Vector2d arm = Eigen::Vector2d::Zero();  ///< from the origin to the centre of mass, at heading 0 [m]

  // Motion that the drive should make in each step of this tick, and its limits; vectors are at heading 0.
  Eigen::Vector2d centre_advance = Eigen::Vector2d::Zero();  ///< [m]
  double turn_rate = 0.0;                                    ///< [rad/s]
  Treels treels;
  double traction = 0.0;  ///< limit of a treel's force [N]
  Drive drive = Drive::kNone;
  int held_by = 0;  ///< number of its grippers
  int place = -1;   ///< in its island, while the island moves
  int rank = -1;    ///< among those present in this tick
  Grip grip;

  // Made on first use.
  std::vector<ContactShape> shapes;
  Support support;

  // Of the last step, in the axes of the plane. Forces of treels are those of the last island, and a first guess in
  // the next large one.
  std::array<Eigen::Vector2d, 2> treel_forces{Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero()};  ///< [N]
  Eigen::Vector2d last_push = Eigen::Vector2d::Zero();  ///< of other drives [N]

  bool isConnected() const { return grip.isHolding() || held_by > 0; }
  /// Whether it does not move at all.
  bool isAtRest() const { return velocity.isZero(0.0) && spin == 0.0; }
  /// Pose of the body's origin. @param similar may have the same heading
  planar::PlacedPose pose(const planar::PlacedPose& similar = {}) const;
};

}  // namespace swarmanoid::dynamics2d

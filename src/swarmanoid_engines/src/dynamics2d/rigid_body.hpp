/// One body of dynamics2d: Box2D's side of it, and the state that is kept in double precision beside Box2D's floats.
#pragma once

#include <box2d/b2_body.h>
#include <box2d/b2_friction_joint.h>
#include <box2d/b2_joint.h>

#include <Eigen/Core>
#include <array>
#include <cstdint>

#include "dynamics2d/units.hpp"
#include "planar/bodies.hpp"

namespace swarmanoid::dynamics2d {

using planar::Body;
using planar::BodyIndex;
using planar::kNoBody;
using planar::PlanarModel;

/// Treels that push against something: the belt is a massless body that moves over the ground as the treels would
/// like to; friction joints between it and the robot pull the robot along, as hard as the ground allows.
struct Belt {
  b2Body* body = nullptr;  ///< null: nothing resists, plain forces do
  std::array<b2FrictionJoint*, 2> treels{};
};

/// What the gripper of a body holds.
struct Grip {
  b2Joint* joint = nullptr;  ///< null: nothing is held, or it has just been torn off
  BodyIndex gripped = kNoBody;
  bool is_torn = false;        ///< in this tick; the structural tree learns it in `connect`
  bool must_open = false;      ///< was torn off: grips again only after it was opened
  b2Vec2 impulse{0.0F, 0.0F};  ///< of the joint since the grip was last looked at, in Box2D's units
};

/// What pushes a body by itself.
enum class Drive : std::uint8_t { kNone, kTreels, kFlight };

/// What drives a body in a step.
struct Push {
  Eigen::Vector2d force = Eigen::Vector2d::Zero();  ///< at heading 0 [N]
  double torque = 0.0;                              ///< about the centre of mass [N m]
};

/// What every step needs comes first: with many bodies, a step costs as much as the memory that it touches.
struct RigidBody {
  b2Body* body = nullptr;   ///< null: it is alone, nothing can reach it in this tick, and Box2D does not have it
  bool is_fast = false;     ///< so that it looks for others, instead of others for it
  bool is_reached = false;  ///< by one that is fast, in this tick
  double way = 0.0;         ///< that it may come in this tick [m]
  double jump = 0.0;        ///< of a mirror: from where it was to where it was put before this tick [m]
  double free_until = 0.0;  ///< nothing slow can reach it until travelled_ (see Dynamics2d) is as large

  // Its motion while it is alone; otherwise Box2D has it.
  Eigen::Vector2d velocity = Eigen::Vector2d::Zero();  ///< of the centre of mass, in the plane [m/s]
  double spin = 0.0;                                   ///< [rad/s]

  // Where the centre of mass is, in double; Box2D's own floats follow.
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();  ///< in the plane [m]
  double heading = 0.0;                              ///< not wrapped [rad]
  b2Vec2 last_centre{0.0F, 0.0F};                    ///< of `body`, after the last step or transform
  float last_angle = 0.0F;
  int touching = 0;                               ///< contacts, counted by Contacts
  double mass = 0.0;                              ///< [kg]
  double inertia = 0.0;                           ///< about the centre of mass [kg m2]
  Eigen::Vector2d arm = Eigen::Vector2d::Zero();  ///< from the origin to the centre of mass, at heading 0 [m]

  // The motion that the drive is to make in each step of this tick, and its forces; vectors are at heading 0.
  Eigen::Vector2d centre_advance = Eigen::Vector2d::Zero();  ///< [m]
  double turn_rate = 0.0;                                    ///< [rad/s]
  Eigen::Vector2d ahead = Eigen::Vector2d::Zero();           ///< the way that treels push
  Eigen::Vector2d axle = Eigen::Vector2d::Zero();            ///< from the right treel to the left one [m]
  double track = 0.0;     ///< between treels; below 0 where a turn to the left is one to the right in the plane [m]
  double traction = 0.0;  ///< the most that a treel pushes with [N]
  Drive drive = Drive::kNone;
  int held_by = 0;  ///< grippers
  Grip grip;
  Belt belt;

  Eigen::Vector2d origin_advance = Eigen::Vector2d::Zero();  ///< in each step of this tick, at heading 0 [m]
  Eigen::Vector2d last_push = Eigen::Vector2d::Zero();       ///< of plain forces in the last step, in the plane [N]
  b2FrictionJoint* ground = nullptr;                         ///< with the ground, of what slides

  bool isAlone() const { return body == nullptr; }
  bool isConnected() const { return grip.joint != nullptr || held_by > 0; }
  bool isFree() const { return touching == 0 && !isConnected(); }

  Eigen::Vector2d velocityNow() const { return isAlone() ? velocity : toMetres(body->GetLinearVelocity()); }
  double spinNow() const { return isAlone() ? spin : static_cast<double>(body->GetAngularVelocity()); }
  /// Nothing moves it, and it moves nothing.
  bool isAtRest() const { return velocityNow().isZero(0.0) && spinNow() == 0.0; }

  /// Sets both, in Box2D too if it has the body.
  void setVelocity(const Eigen::Vector2d& linear, double angular);
  /// Puts Box2D's body where `centre` and `heading` say, if there is one.
  void writeTransform();
  /// Adds what Box2D moved the body by in a step of `h` seconds.
  void readStep(double h);
  /// Where the body's origin is. @param similar it may have the same heading
  planar::PlacedPose pose(const planar::PlacedPose& similar = {}) const;
};

}  // namespace swarmanoid::dynamics2d

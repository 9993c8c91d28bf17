/// One body of dynamics2d: Box2D's side of it, and the state that is kept in double precision beside Box2D's floats.
#pragma once

#include <box2d/b2_body.h>
#include <box2d/b2_circle_shape.h>
#include <box2d/b2_friction_joint.h>
#include <box2d/b2_joint.h>
#include <box2d/b2_polygon_shape.h>

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
  bool is_torn = false;    ///< in this tick; the structural tree learns it in `connect`
  bool must_open = false;  ///< was torn off: grips again only after it was opened
};

/// What pushes a body by itself.
enum class Drive : std::uint8_t { kNone, kTreels, kFlight };

/// What every step needs comes first: with many bodies, a step costs as much as the memory that it touches.
struct RigidBody {
  b2Body* body = nullptr;

  // Where the centre of mass is, in double; Box2D's own floats follow.
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();  ///< in the plane [m]
  double heading = 0.0;                              ///< not wrapped [rad]
  b2Vec2 last_centre{0.0F, 0.0F};                    ///< of `body`, after the last step or transform
  float last_angle = 0.0F;
  int touching = 0;                               ///< contacts, counted by Contacts
  double mass = 0.0;                              ///< [kg]
  double inertia = 0.0;                           ///< about the centre of mass [kg m2]
  Eigen::Vector2d arm = Eigen::Vector2d::Zero();  ///< from the origin to the centre of mass, at heading 0 [m]

  // What the drive wants in each step of this tick, and what it has for it; vectors are at heading 0.
  Eigen::Vector2d centre_advance = Eigen::Vector2d::Zero();  ///< [m]
  double turn_rate = 0.0;                                    ///< [rad/s]
  Eigen::Vector2d ahead = Eigen::Vector2d::Zero();           ///< the way that treels push
  double track = 0.0;     ///< between treels; below 0 where a turn to the left is one to the right in the plane [m]
  double traction = 0.0;  ///< the most that a treel pushes with [N]
  Drive drive = Drive::kNone;
  int held_by = 0;  ///< grippers
  Grip grip;
  Belt belt;

  Eigen::Vector2d origin_advance = Eigen::Vector2d::Zero();  ///< in each step of this tick, at heading 0 [m]
  double thickness = 0.0;                                    ///< half the thickness of the thickest shape [m]
  b2Vec2 last_push{0.0F, 0.0F};                              ///< of plain forces in the last step, in Box2D's units
  b2FrictionJoint* ground = nullptr;                         ///< with the ground, of what slides

  bool isConnected() const { return grip.joint != nullptr || held_by > 0; }
  bool isFree() const { return touching == 0 && !isConnected(); }

  /// Puts Box2D's body where `centre` and `heading` say.
  void writeTransform();
  /// Adds what Box2D moved the body by in a step of `h` seconds.
  void readStep(double h);
  /// Where the body's origin is.
  planar::PlacedPose pose() const;
};

/// Gives a body its shapes, as fixtures that know their number in the model. Box2D has polygons of up to eight corners:
/// those with more become several.
void addFixtures(b2Body& body, const PlanarModel& model, float friction, float restitution);

/// Give Box2D's shapes the extent of a planar one. @pre it is a circle; a polygon with room for its corners in Box2D's
void setShape(const planar::PlanarShape& shape, b2CircleShape& circle);
void setShape(const planar::PlanarShape& shape, b2PolygonShape& polygon);

/// Puts the shapes that a joint turns where the projection of the model now has them.
void turnFixtures(b2Body& body, const PlanarModel& model, const EntityModel& entity, int joint);

/// The thinnest shape that Box2D can be given [m].
constexpr double kThinnest = 1e-3;

}  // namespace swarmanoid::dynamics2d

/// One entity in a dynamic engine: its rigid body and solids in ODE, and its commands.
///
/// Frames: W; the body frame B of the entity's model. ODE's body sits in the centre of mass with B's axes. A robot
/// whose arms are driven has a rigid body for each link that a joint turns, besides the one for what no joint turns;
/// their axes are those of B while all joints are at zero.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "dynamics3d/ode.hpp"
#include "dynamics3d/settings.hpp"
#include "dynamics3d/turret.hpp"
#include "swarmanoid_interface/devices/eyebot_magnet.hpp"
#include "swarmanoid_interface/devices/eyebot_velocity.hpp"
#include "swarmanoid_interface/devices/footbot_gripper.hpp"
#include "swarmanoid_interface/devices/footbot_wheels.hpp"
#include "swarmanoid_interface/devices/handbot_arms.hpp"
#include "swarmanoid_interface/devices/handbot_hands.hpp"
#include "swarmanoid_interface/devices/handbot_rope.hpp"
#include "swarmanoid_space/space.hpp"

namespace swarmanoid::dynamics3d {

/// One collision solid of a body.
struct Solid {
  enum class Kind {
    kPlain,   ///< a shape of the model
    kWheel,   ///< the ball on which half of a robot stands, and which drives it; see treels.hpp
    kSupport  ///< a ball before or behind a wheel that keeps the robot from tipping
  };

  dGeomID geom = nullptr;
  Kind kind = Kind::kPlain;
  int side = 0;             ///< of a wheel: 0 left, 1 right
  int joint = -1;           ///< that turns it, in the model; -1: none
  Eigen::AlignedBox3d box;  ///< around it, in the step under way
};

/// A link that a joint of the model turns. See arms.hpp.
struct Link {
  dBodyID rigid = nullptr;
  dJointID hinge = nullptr;  ///< with the motor
  dJointFeedback feedback = {};
  dJointID stop = nullptr;  ///< idle within the joint's range
  dJointFeedback stop_feedback = {};
  double angle = 0.0;              ///< as of the start of the step, not wrapped [rad]
  const double* target = nullptr;  ///< the commanded angle of the joint [rad]; null: 0
};

/// What a robot's treels do.
struct Treels {
  double rim_speed[2] = {0.0, 0.0};  ///< left, right [m/s]; follows the command as fast as the motors can
};

/// What an eyebot's flight controller remembers.
struct Flight {
  bool is_holding = false;
  Eigen::Vector3d held = Eigen::Vector3d::Zero();  ///< where its centre of mass would be, had it flown as commanded [m]
  double heading = 0.0;                            ///< likewise [rad]
};

struct Body;

/// What a gripper, a hand or a magnet holds.
struct Grip {
  Body* gripped = nullptr;
  dBodyID holder = nullptr;  ///< the rigid body of the robot that holds it
  dJointID joint = nullptr;
  dJointFeedback feedback = {};
  Eigen::Vector3d force = Eigen::Vector3d::Zero();  ///< on the gripper, in B, without the noise of single steps [N]
  bool is_broken = false;                           ///< in this tick; `connect` reports it
  bool must_open = false;                           ///< it broke, and was not opened since
};

/// A handbot's rope. See rope.hpp.
struct Rope {
  Body* held = nullptr;                                ///< by the magnet at its end; null: nothing
  Eigen::Vector3d anchor = Eigen::Vector3d::Zero();    ///< where, in the frame B of `held` [m]
  double length = 0.0;                                 ///< from launcher to anchor, when taut [m]
  double winding = 0.0;                                ///< how fast it shortens in the step under way [m/s]
  double tension = 0.0;                                ///< without the noise of single steps [N]
  dJointFeedback feedback = {};                        ///< of the step
  Eigen::Vector3d towards = Eigen::Vector3d::UnitZ();  ///< the anchor, from the launcher, in the step; in W
  double flown = 0.0;                                  ///< how far, if it was shot and has met nothing so far [m]
  bool is_broken = false;                              ///< in this tick; `connect` reports it
  bool must_rewind = false;  ///< it broke, met nothing to hold or lost what it held, and was not called back since
};

/// What a robot holds on to by its hands, its magnet and its rope. Few robots have any, and none of the others is to
/// pay for them.
struct Holding {
  // Its commands; null if it has no such device.
  const HandbotHands* hands = nullptr;
  const HandbotRope* rope_command = nullptr;
  const EyebotMagnet* magnet = nullptr;

  std::array<Grip, Attachment::kKinds> grips;  ///< by hands and magnet; the rope is not among them
  Rope rope;

  Grip& grip(Attachment::Kind kind) { return grips[static_cast<std::size_t>(kind)]; }
  const Grip& grip(Attachment::Kind kind) const { return grips[static_cast<std::size_t>(kind)]; }
};

struct Body {
  Body() = default;
  ~Body();
  Body(const Body&) = delete;
  Body& operator=(const Body&) = delete;

  EntityNumber number = kNoEntity;
  Row row = kNoRow;
  Role role = Role::kMove;
  std::shared_ptr<const EntityModel> model;
  int rank = 0;  ///< among all bodies, by entity number

  dBodyID rigid = nullptr;  ///< null: fixed in the world
  Inertial own;             ///< of `rigid`: the whole entity, or what no joint turns
  std::vector<Link> links;  ///< by the model's joints; empty: all of the entity is one rigid body
  bool is_dynamic = false;  ///< forces move it; otherwise it is fixed or a mirror
  std::vector<Solid> solids;
  Eigen::Vector3d pull = Eigen::Vector3d::Zero();  ///< by grips, as of late [N]

  Pose pose;                       ///< of B, as of the end of the last tick: what rays hit
  bool is_seen_elsewhere = false;  ///< a mirror; rays hit the entity in the engine that moves it

  // Its commands; null if it has no such device, or not the parts for it.
  const FootbotWheels* wheels = nullptr;
  const EyebotVelocity* velocity = nullptr;
  const FootbotGripper* gripper = nullptr;

  Treels treels;
  Flight flight;
  Grip grip;
  std::unique_ptr<Holding> holding;  ///< null: it has neither hands nor a rope nor a magnet
  Turret turret;

  /// What rays hit: the model with its shapes where the joints have turned them.
  const EntityModel& seen() const { return posed_ == nullptr ? *model : *posed_; }
  void poseShapes(const JointState* joints);

  /// Of B, now. @pre rigid
  Pose currentPose() const;
  Twist currentTwist() const;
  /// @param joints states of the model's joints; null: all are zero
  void setPose(const Pose& pose, const JointState* joints = nullptr);
  /// After setPose. @pre rigid
  void setTwist(const Twist& twist, const JointState* joints = nullptr);

  /// Of ODE's bodies, for a step that may have to be done again.
  void saveState();
  void restoreState();

 private:
  friend std::unique_ptr<Body> makeBody(dWorldID world, const Space& space, Row row, Role role);

  struct State {
    dVector3 position;
    dQuaternion orientation;
    dVector3 linear;
    dVector3 angular;
    dVector3 force;
    dVector3 torque;
  };
  template <class Visit>
  void visitRigids(Visit visit);

  std::vector<State> saved_;            // one for each rigid body
  std::unique_ptr<EntityModel> posed_;  // null: no joint turns a shape
};

/// Makes the body and its solids at the entity's pose in the space.
/// @pre no other body of that entity; an OdeLock is held
std::unique_ptr<Body> makeBody(dWorldID world, const Space& space, Row row, Role role);

}  // namespace swarmanoid::dynamics3d

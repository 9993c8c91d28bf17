/// One entity in a dynamic engine: its rigid body and solids in ODE, and what it is told to do.
///
/// Frames: W; the body frame B of the entity's model. ODE's body sits in the centre of mass with B's axes.
#pragma once

#include <memory>
#include <vector>

#include "dynamics3d/ode.hpp"
#include "dynamics3d/settings.hpp"
#include "dynamics3d/turret.hpp"
#include "swarmanoid_interface/devices/eyebot_velocity.hpp"
#include "swarmanoid_interface/devices/footbot_gripper.hpp"
#include "swarmanoid_interface/devices/footbot_wheels.hpp"
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
  int side = 0;  ///< of a wheel: 0 left, 1 right
};

/// What a robot's treels do.
struct Treels {
  double rim_speed[2] = {0.0, 0.0};  ///< left, right [m/s]; follows the command as fast as the motors can
};

/// What an eyebot's flight controller remembers.
struct Flight {
  bool is_holding = false;
  Eigen::Vector3d held = Eigen::Vector3d::Zero();  ///< where its centre of mass would be, had it flown as told [m]
  double heading = 0.0;                            ///< likewise [rad]
};

struct Body;

/// What a gripper holds.
struct Grip {
  Body* gripped = nullptr;
  dJointID joint = nullptr;
  dJointFeedback feedback = {};
  Eigen::Vector3d force = Eigen::Vector3d::Zero();  ///< on the gripper, in B, without the noise of single steps [N]
  bool is_broken = false;                           ///< in this tick; `connect` tells everybody
  bool must_open = false;                           ///< it broke, and was not opened since
};

struct Body {
  Body() = default;
  ~Body();
  Body(const Body&) = delete;
  Body& operator=(const Body&) = delete;

  EntityNumber number = kNobody;
  Row row = kNoRow;
  Role role = Role::kMove;
  std::shared_ptr<const EntityModel> model;
  int rank = 0;  ///< among all bodies, by entity number

  dBodyID rigid = nullptr;  ///< null: fixed in the world
  bool is_dynamic = false;  ///< forces move it; otherwise it is fixed or a mirror
  std::vector<Solid> solids;
  Eigen::Vector3d pull = Eigen::Vector3d::Zero();  ///< by grips, as of late [N]

  Pose pose;                       ///< of B, as of the end of the last tick: what rays meet
  bool is_seen_elsewhere = false;  ///< a mirror; rays meet the entity in the engine that moves it

  // What it is told; null if it has no such device, or not the parts for it.
  const FootbotWheels* wheels = nullptr;
  const EyebotVelocity* velocity = nullptr;
  const FootbotGripper* gripper = nullptr;

  Treels treels;
  Flight flight;
  Grip grip;
  Turret turret;

  /// Of B, now. @pre rigid
  Pose currentPose() const;
  Twist currentTwist() const;
  void setPose(const Pose& pose);
  /// @pre rigid
  void setTwist(const Twist& twist);

  /// Of ODE's body, for a step that may have to be done again.
  void saveState();
  void restoreState();

 private:
  struct State {
    dVector3 position;
    dQuaternion orientation;
    dVector3 linear;
    dVector3 angular;
    dVector3 force;
    dVector3 torque;
  };
  State saved_ = {};
};

/// Makes the body and its solids at the entity's pose in the space.
/// @pre no other body of that entity; a Turn is held
std::unique_ptr<Body> makeBody(dWorldID world, const Space& space, Row row, Role role);

}  // namespace swarmanoid::dynamics3d

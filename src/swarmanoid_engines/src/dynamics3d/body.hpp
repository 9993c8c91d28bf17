/// One entity in a dynamic engine: its rigid body and solids in ODE, and its commands.
///
/// Frames: W; the body frame B of the entity's model. ODE's body sits in the centre of mass with B's axes. A robot with
/// driven arms has a rigid body for each link that a joint turns, and one for the rest; their axes are those of B while
/// all joints are at zero.
#pragma once

#include <memory>
#include <vector>

#include "dynamics3d/mechanisms/turret.hpp"
#include "dynamics3d/ode.hpp"
#include "dynamics3d/settings.hpp"
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
  int joint = -1;           ///< joint of the model that turns it; -1: none
  Eigen::AlignedBox3d box;  ///< around it, in the current step
};

/// Rotation of a rigid body of a hanging robot in a step, in its own frame. See hanging.hpp.
struct Turning {
  Eigen::Vector3d before = Eigen::Vector3d::Zero();  ///< at the start of the step [rad/s]
  Eigen::Vector3d change = Eigen::Vector3d::Zero();  ///< in the last solution [rad/s]
};

/// A link that a joint of the model turns. See arms.hpp.
struct Link {
  dBodyID rigid = nullptr;
  dJointID hinge = nullptr;  ///< with the motor
  dJointFeedback feedback = {};
  dJointID stop = nullptr;  ///< idle within the joint's range
  dJointFeedback stop_feedback = {};
  double angle = 0.0;    ///< as of the start of the step, not wrapped [rad]
  JointCommand command;  ///< of this tick

  // For hanging robots.
  Turning turning;
  Eigen::Vector3d opening = Eigen::Vector3d::Zero();    ///< hinge gap of an uncorrected step, in the link's frame [m]
  Eigen::Vector3d displaced = Eigen::Vector3d::Zero();  ///< displacement of the link during a solution, in W [m]
};

/// State of a robot's treels.
struct Treels {
  double rim_speed[2] = {0.0, 0.0};  ///< left, right [m/s]; follows the command as fast as the motors can
  double run[2] = {0.0, 0.0};        ///< left, right: distance run in this tick [m]
};

/// State of the flight controller of a flying robot.
struct Flight {
  bool is_holding = false;
  Eigen::Vector3d held = Eigen::Vector3d::Zero();  ///< set point of the centre of mass [m]
  double heading = 0.0;                            ///< set point [rad]
};

/// Whether a body moves steadily. See steady_motion.hpp.
struct Steadiness {
  bool is_left_out = false;  ///< moved without ODE for the rest of the current tick
  Eigen::AlignedBox3d box;   ///< around it in the current step; if left out, around its way in that tick; in W
  double time = 0.0;         ///< since its motion last changed [s]
  Eigen::Vector3d linear = Eigen::Vector3d::Zero();  ///< velocity of its centre of mass in the last step, in B [m/s]
  double turn_rate = 0.0;                            ///< about the vertical, in the last step [rad/s]
};

struct Body;

/// Grip of a holder without a rope.
struct Grip {
  Body* gripped = nullptr;
  dBodyID holder = nullptr;  ///< the rigid body of the robot that holds it
  dJointID joint = nullptr;
  dJointFeedback feedback = {};
  Eigen::Vector3d force = Eigen::Vector3d::Zero();  ///< on the gripper, in B, low-pass filtered [N]
  bool is_broken = false;                           ///< in this tick; `connect` reports it
  bool must_open = false;                           ///< it broke, and was not opened since

  /// False if the grip has broken in this tick.
  bool holds(const Body& object) const { return gripped == &object && joint != nullptr; }
};

/// A rope. See rope.hpp.
struct Rope {
  Body* held = nullptr;                                ///< by the magnet at its end; null: no body
  Eigen::Vector3d anchor = Eigen::Vector3d::Zero();    ///< of the magnet, in the frame B of `held` [m]
  double length = 0.0;                                 ///< from launcher to anchor, when taut [m]
  double wanted_winding = 0.0;                         ///< commanded in this tick [m/s]
  double winding = 0.0;                                ///< speed at which it shortens in the current step [m/s]
  double tension = 0.0;                                ///< low-pass filtered [N]
  dJointFeedback feedback = {};                        ///< of the step
  Eigen::Vector3d towards = Eigen::Vector3d::UnitZ();  ///< direction from the launcher to the anchor, in the step; in W
  double correction = 0.0;                             ///< additional pulling speed that keeps its length [m/s]
  double flown = 0.0;                                  ///< length flown since it was shot, until it hits something [m]
  bool is_broken = false;                              ///< in this tick; `connect` reports it
  bool must_rewind = false;  ///< it broke, missed or lost its body, and was not called back since
};

/// Grips and ropes of a robot's holders other than its gripper. Allocated only for the few robots that need it.
struct Holding {
  explicit Holding(const EntityModel& model) : grips(model.holders.size()), ropes(model.holders.size()) {}

  // Both by the model's holders; those of a rope use `ropes`, the others `grips`.
  std::vector<Grip> grips;
  std::vector<Rope> ropes;

  bool hangs = false;  ///< on a taut rope, in the last solution
  Turning turning;     ///< of Body::rigid
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

  dBodyID rigid = nullptr;  ///< null: fixed in the world; ODE's user data of all its rigid bodies is this Body
  Inertial own;             ///< of `rigid`: the whole entity, or the part that no joint turns
  std::vector<Link> links;  ///< by the model's joints; empty: the entity is one rigid body
  bool is_dynamic = false;  ///< forces move it; otherwise it is fixed or a mirror
  std::vector<Solid> solids;
  Eigen::Vector3d pull = Eigen::Vector3d::Zero();  ///< by grips, low-pass filtered [N]

  Pose pose;                       ///< of B at the end of the last tick; rays hit it there
  bool is_seen_elsewhere = false;  ///< a mirror; rays hit the entity in the engine that moves it

  // Commands of the current tick.
  WheelsCommand wheels_command;
  FlightCommand flight_command;
  int gripper = -1;  ///< index of the commanded holder; -1: none

  Treels treels;
  Flight flight;
  Grip grip;
  std::unique_ptr<Holding> holding;  ///< null: no such holder is commanded or holds a body
  Turret turret;
  Steadiness steadiness;
  /// Solver of the body's island in the current step (islands.hpp).
  enum class Island {
    kNone,     ///< no island: between steps, or with `iterative`
    kSmall,    ///< ODE's exact solver
    kSolved,   ///< solved by ODE's exact solver, while solutions of other islands are corrected
    kLarge,    ///< ODE's iterative solver
    kContacts  ///< contact solver
  };
  Island island = Island::kNone;
  int island_first = 0;  ///< rank of the first body of the island

  /// Whether ODE moves it in the current step.
  bool isInOde() const { return is_dynamic && !steadiness.is_left_out; }

  const EntityModel::Holder& holder(std::size_t index) const { return model->holders[index]; }

  /// The model that rays hit: its shapes are where the joints have turned them.
  const EntityModel& seen() const { return posed_ == nullptr ? *model : *posed_; }
  void poseShapes(Span<const JointState> joints);

  /// Current state of B. @pre rigid
  Pose currentPose() const;
  Twist currentTwist() const;
  /// @param joints states of the model's joints; empty: all are at zero
  void setPose(const Pose& pose, Span<const JointState> joints = {});
  /// The caller must call setPose first. @pre rigid
  void setTwist(const Twist& twist, Span<const JointState> joints = {});

  /// State of ODE's bodies, for a step that may be repeated.
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

/// Whether one of the bodies grips the other.
inline bool areJoined(const Body& a, const Body& b) { return a.grip.holds(b) || b.grip.holds(a); }

/// Copies the commands of a tick from the space.
void readCommands(const Space& space, Body& body);

/// Makes the body and its solids at the entity's pose in the space.
/// @pre no other body of that entity; an OdeLock is held
std::unique_ptr<Body> makeBody(dWorldID world, const Space& space, Row row, Role role);

}  // namespace swarmanoid::dynamics3d

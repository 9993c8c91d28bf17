/// The two-dimensional dynamic engine (thesis 3.5.2), on Box2D: rigid bodies on a plane, with mass, friction with the
/// ground, collisions and grips.
///
/// Gravity presses bodies on the plane; in it nothing pulls them. Preys and blocks slide with Coulomb friction. Treels
/// drive a footbot with the force that their commanded speeds ask for, up to what the ground holds: beyond, they slip.
/// Flight pushes an eyebot towards its commanded velocity with limited acceleration. What would lead out of the plane
/// is dropped. A gripper holds anything with a gripping strip (preys, footbots, handbots), as a rigid joint that tears
/// at a stated force; several may hold one object, and chains are allowed, as far as the structural tree is
/// (thesis 3.4).
///
/// What the gripper of a robot with a turret holds turns about the robot's centre, by a motor with no more than the
/// turret's torque: a load that is too heavy to turn turns the robot instead. A turret without load turns as
/// commanded, and stops before its gripper would sink into something.
///
/// Bodies rest where their surfaces meet, within 0.1 mm, and sink into each other by up to 0.6 mm when they meet: Box2D
/// finds the times of all impacts, and steps are finer where something fast is near. What nothing can reach in a tick
/// is moved without Box2D. The positions of entities are integrated in double precision from Box2D's velocities, so
/// small steps far from the origin lose nothing.
///
/// A mirror is a body that nothing pushes: it is where the space says, and moves through the tick with its last twist.
#pragma once

#include <box2d/b2_world.h>

#include <memory>
#include <vector>

#include "dynamics2d/contacts.hpp"
#include "dynamics2d/rigid_body.hpp"
#include "planar/planar_engine.hpp"

namespace swarmanoid::dynamics2d {

/// Parameters of the engine, all of which may change live; SI units.
struct Material {
  int iterations = 12;            ///< of the solver of contacts and joints, in each step
  double gravity = 9.81;          ///< that presses on the plane [m/s2]
  double ground_friction = 0.4;   ///< of what slides
  double treel_friction = 0.9;    ///< of treels
  double contact_friction = 0.3;  ///< between bodies
  double restitution = 0.0;       ///< between bodies
  double grip_strength = 50.0;    ///< a grip tears beyond it [N]
};

class Dynamics2d final : public planar::PlanarEngine {
 public:
  Dynamics2d();
  static PluginDescription describe();

  void configure(const std::string& id, const Configuration& parameters) override;
  void reconfigure(const Configuration& parameters) override;
  std::string unsupportedReason(const EntityModel& model, const std::vector<DeviceUse>& devices) const override;
  std::string invalidPoseReason(const EntityModel& model, const Pose& pose) const override;
  std::string unsupportedGripReason(const Space&, Row) const override { return ""; }
  void add(Space& space, Row row, Role role) override;
  void remove(Space& space, Row row) override;
  void place(Space& space, Row row) override;
  void clear() override;
  void readMirrors(const Space& space) override;
  void move(Space& space, Duration dt) override;
  void connect(Space& space) override;
  void draw(EngineDrawing& drawing) const override;
  double gravity() const override { return material_.gravity; }

  /// Box2D's world: what stands, mirrors, and the movers that something may reach in a tick.
  const b2World& world() const { return *world_; }

 private:
  const RigidBody& rigid(BodyIndex index) const { return rigid_bodies_[static_cast<std::size_t>(index)]; }
  RigidBody& rigid(BodyIndex index) { return rigid_bodies_[static_cast<std::size_t>(index)]; }

  // dynamics2d.cpp
  void makeWorld();
  void makeBody(BodyIndex index);
  void makeFixtures(BodyIndex index);
  void measureMass(BodyIndex index);
  void putBody(const Space& space, BodyIndex index);
  void takePose(const Space& space, BodyIndex index);

  // motion.cpp
  void startTick(const Space& space, double tick);
  void choosePieces(double step);
  void moveInBox2d();
  void joinGround(BodyIndex index);
  void setGroundFriction(BodyIndex index);
  void finishTick(Space& space, double tick);

  // drive.cpp
  void prepareDrive(BodyIndex index, double step);
  void drive(BodyIndex index, double step);
  void driveAlone(BodyIndex index, double step, int steps);
  void makeBelt(const Body& body, RigidBody& rigid_body);
  static void moveBelt(RigidBody& rigid_body, double step);
  void dropBelt(RigidBody& rigid_body);

  // alone.cpp
  /// What a body may reach in this tick by itself: its own as it is, or its command if that is more.
  struct Rates {
    double speed;  ///< of its centre of mass [m/s]
    double turn;   ///< rad/s
  };
  Rates highestRates(BodyIndex index);
  void measureWay(BodyIndex index, double tick, double jump);
  void sortOut();
  void warnOthers(BodyIndex index);
  void lookAround(BodyIndex index);
  void enterBox2d(BodyIndex index);
  void leaveBox2d(BodyIndex index);
  void moveAlone(double tick);

  // turret.cpp
  void driveTurrets(double step);
  void turnFreely(planar::Turret& turret, double step);
  double separation(const planar::Turret& turret, const PlanarModel& model);
  void turnGripper(const planar::Turret& turret);
  b2Joint* makeTurretJoint(planar::Turret& turret, BodyIndex gripped);
  void readTurrets(double step);
  void finishTurrets(Space& space);

  // drawing.cpp
  void drawContacts(EngineDrawing& drawing) const;
  void drawForces(BodyIndex index, EngineDrawing& drawing) const;

  // gripping.cpp
  BodyIndex findGrippable(const Space& space, BodyIndex gripper) const;
  void hold(BodyIndex gripper, BodyIndex gripped);
  void letGo(BodyIndex gripper);
  void forgetGrips(BodyIndex index);
  void takeOverGrips(const Space& space, BodyIndex index);
  void readGrips(double step);
  void tearGrips(double time);

  /// How far any body comes without the others seeing it before it looks around again [m].
  static constexpr double kLookAhead = 0.3;

  Material material_;
  int pieces_ = 1;                       // that each step is made in, in this tick
  double last_step_ = 0.1;               // [s]
  double longest_way_ = 0.0;             // m, of any body in this tick
  double longest_slow_way_ = 0.0;        // m, of those that are not fast
  double travelled_ = 0.0;               // m, no body that was not fast has moved farther since the start
  std::vector<RigidBody> rigid_bodies_;  // by body
  std::vector<BodyIndex> movers_;        // what Box2D moves, by entity number
  std::vector<BodyIndex> present_;       // those of them that Box2D has in this tick, by entity number
  std::vector<BodyIndex> mirrors_;       // that may move, by entity number
  std::vector<BodyIndex> grippers_;      // that hold something, by entity number
  Contacts contacts_{bodies_, rigid_bodies_};
  std::unique_ptr<b2World> world_;
  b2Body* ground_ = nullptr;
};

}  // namespace swarmanoid::dynamics2d

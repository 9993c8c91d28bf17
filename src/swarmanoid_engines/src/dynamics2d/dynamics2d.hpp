/// The two-dimensional dynamic engine (thesis 3.5.2): rigid bodies on a plane, with mass, friction with the ground,
/// collisions and grips. Box2D finds contacts; forces are solved in double precision.
///
/// Gravity presses bodies onto the plane and has no component along it. Preys and blocks slide with Coulomb friction on
/// each element of their support (support.hpp). Treels drive a footbot with the force that their commanded speeds need,
/// up to the friction limit of the ground; beyond it they slip. Flight pushes an eyebot towards its commanded velocity
/// with limited acceleration. Velocity out of the plane is dropped. A gripper holds any body with a gripping strip
/// (preys, footbots, handbots) by a rigid joint that tears at a given force; several may hold one object, and chains
/// are allowed, as far as the structural tree allows them (thesis 3.4).
///
/// A body in the gripper of a robot with a turret turns about the robot's centre, by a motor with no more than the
/// turret's torque: a load that is too heavy to turn turns the robot instead. A turret without load turns as commanded,
/// and stops before its gripper would penetrate another body.
///
/// Bodies that nothing can reach in a tick move alone. Bodies that may meet form islands (island.hpp), which move one
/// after another, each in steps as fine as its own motion needs.
///
/// A mirror is a body that no force moves: it has the pose from the space, and moves through the tick with its last
/// twist.
#pragma once

#include <utility>
#include <vector>

#include "dynamics2d/rigid_body.hpp"
#include "dynamics2d/solver/crowd_memory.hpp"
#include "dynamics2d/solver/island.hpp"
#include "planar/planar_engine.hpp"

namespace swarmanoid::dynamics2d {

/// Parameters of the engine; all but `pressure` may change live. SI units.
struct Material {
  int iterations = 1000;                ///< limit for the solver of an island, in each step
  double gravity = 9.81;                ///< presses bodies onto the plane [m/s2]
  double ground_friction = 0.4;         ///< of sliding bodies
  double treel_friction = 0.9;          ///< of treels
  double contact_friction = 0.3;        ///< between bodies
  double restitution = 0.0;             ///< between bodies
  Pressure pressure = Pressure::kEven;  ///< distribution of a body's weight over its support
  double grip_strength = 50.0;          ///< a grip tears beyond it [N]
};

/// A contact for drawings.
struct DrawnContact {
  BodyIndex body = kNoBody;
  Eigen::Vector2d point;   ///< in the plane [m]
  Eigen::Vector2d normal;  ///< into `body`
};

class Dynamics2d final : public planar::PlanarEngine {
 public:
  static PluginDescription describe();

  void configure(const std::string& id, const Configuration& parameters) override;
  void reconfigure(const Configuration& parameters) override;
  std::string unsupportedReason(const EntityModel& model, const std::vector<DeviceUse>& devices) const override;
  void add(const Space& space, Row row, Role role) override;
  void remove(const Space& space, Row row) override;
  void place(const Space& space, Row row) override;
  void clear() override;
  void readMirrors(const Space& space) override;
  void move(const Space& space, const MoveAccess& access, Duration dt) override;
  void connect(const Space& space, const ConnectAccess& access) override;
  void archive(const Space& space, StateArchive& state) override;
  void draw(EngineDrawing& drawing) const override;
  double gravity() const override { return material_.gravity; }

  /// Number of bodies that moved in islands in the last tick; the others were alone.
  std::size_t bodiesInIslands() const { return present_.size(); }

 private:
  const RigidBody& rigid(BodyIndex index) const { return rigid_bodies_[static_cast<std::size_t>(index)]; }
  RigidBody& rigid(BodyIndex index) { return rigid_bodies_[static_cast<std::size_t>(index)]; }

  // dynamics2d.cpp
  void measureMass(BodyIndex index);
  void forgetShapes(BodyIndex index);
  void takePose(const Space& space, BodyIndex index);
  void takeMotion(const Space& space, BodyIndex index);

  // motion.cpp
  void startTick(const Space& space, double tick);
  void finishTick(const Space& space, const MoveAccess& access, double tick);

  // alone.cpp
  /// Bounds on the motion of a body by itself in this tick: the current or the commanded one, whichever is larger.
  struct Rates {
    double speed;  ///< of its centre of mass [m/s]
    double turn;   ///< rad/s
  };
  Rates highestRates(BodyIndex index);
  /// Upper bound for any point of its outline [m/s].
  double highestSpeed(BodyIndex index);
  void measureWay(BodyIndex index, double tick, double jump);
  void sortOut();
  void warnOthers(BodyIndex index);
  void lookAround(BodyIndex index);
  void moveAlone(double tick);

  // drive.cpp
  void prepareDrive(BodyIndex index, double step);
  void driveAlone(BodyIndex index, double step, int steps);

  // islands.cpp
  /// Two bodies that may meet in a tick. The first one is present; the second one may be a mirror or fixed.
  using Near = std::pair<BodyIndex, BodyIndex>;
  void findNear();
  void joinIslands();
  int rootOf(int rank);
  void moveIslands(double tick);

  // move_island.cpp
  /// Copies `members_` and `near_of_island_` to `island_`.
  void fillIsland();
  int placeOf(BodyIndex index);
  void addPair(const Near& near);
  /// Whether the island has grips, or its bodies may touch in a tick [s] at their current or commanded speeds.
  bool mayTouch(double tick) const;
  /// Whether the island has grips, or bodies that slide on the ground.
  bool hasLoad() const;
  /// Number of pieces of each step of the island in this tick. @param step [s]
  int countPieces(double step);
  void moveIsland(double tick);
  BodyNumbers numbersOf(int place_a, int place_b) const;
  /// Fills the contacts of the last tick.
  void recallContacts(double step);
  void keepContacts(double step);
  void addConstraints(BodyIndex index, double step);
  const Support& supportOf(BodyIndex index);
  void addGrip(BodyIndex index);
  void readGrips(double step);
  /// Copies `island_` to its bodies, after its last step. @param step length of that step [s]
  void readIsland(double step);
  void readMotions();
  /// For drawings, and to start the treels of large islands in the next tick.
  void noteForces(double step);

  // turret.cpp
  /// Drives the turrets of the island.
  void driveTurrets(double step);
  void turnFreely(planar::Turret& turret, double step);
  double gapAround(const planar::Turret& turret, const PlanarModel& model);
  void turnGripper(const planar::Turret& turret);
  void aimTurret(GripConstraint& grip, double step);
  void readTurret(const GripConstraint& grip, double step);
  void finishTurrets(const MoveAccess& access);

  // drawing.cpp
  void drawForces(BodyIndex index, EngineDrawing& drawing) const;

  // gripping.cpp
  BodyIndex findGrippable(const Space& space, BodyIndex gripper) const;
  void hold(BodyIndex gripper, BodyIndex gripped);
  void letGo(BodyIndex gripper);
  void forgetGrips(BodyIndex index);
  void takeOverGrips(const Space& space, BodyIndex index);
  /// Tears the overloaded grips of the island. @param time since the last call [s]
  void tearGrips(double time);

  /// Range of a search for neighbours [m]. Adding it to travelled_ makes all bodies search again.
  static constexpr double kLookAhead = 0.3;

  Material material_;
  double longest_way_ = 0.0;             // m, of any body in this tick
  double longest_slow_way_ = 0.0;        // m, of bodies that are not fast
  double travelled_ = 0.0;               // m, upper bound on the motion of bodies that are not fast, since the start
  std::vector<RigidBody> rigid_bodies_;  // by body
  std::vector<BodyIndex> movers_;        // bodies that the engine moves, by entity number
  std::vector<BodyIndex> present_;       // movers in islands of this tick, by entity number
  std::vector<BodyIndex> mirrors_;       // movable ones, by entity number
  std::vector<BodyIndex> grippers_;      // bodies that hold something, by entity number

  std::vector<Near> near_;           // of this tick, by entity numbers
  std::vector<int> roots_;           // by rank: a body of the same island, with a lower rank
  std::vector<BodyIndex> members_;   // of the current island, by place; then its mirrors and fixed bodies
  std::size_t movable_members_ = 0;  // number of them
  std::vector<Near> near_of_island_;
  std::vector<std::pair<int, int>> order_of_islands_;  // root and rank of present bodies
  Island island_;                                      // the current one
  CrowdMemory crowd_memory_;                           // of large islands
  std::vector<DrawnContact> contacts_;                 // of the last steps of this tick
  std::vector<ContactShape> tried_shapes_;             // scratch of gapAround
};

}  // namespace swarmanoid::dynamics2d

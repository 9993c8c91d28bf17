/// The two-dimensional dynamic engine (thesis 3.5.2): rigid bodies on a plane, with mass, friction with the ground,
/// collisions and grips. Box2D finds contacts; forces are solved in double precision.
///
/// Gravity presses bodies on the plane; in it nothing pulls them. Preys and blocks slide with Coulomb friction on each
/// element of what they stand on (support.hpp). Treels drive a footbot with the force that their commanded speeds ask
/// for, up to what the ground holds: beyond, they slip. Flight pushes an eyebot towards its commanded velocity with
/// limited acceleration. What would lead out of the plane is dropped. A gripper holds anything with a gripping strip
/// (preys, footbots, handbots), as a rigid joint that tears at a stated force; several may hold one object, and chains
/// are allowed, as far as the structural tree is (thesis 3.4).
///
/// A body in the gripper of a robot with a turret turns about the robot's centre, by a motor with no more than the
/// turret's torque: a load that is too heavy to turn turns the robot instead. A turret without load turns as commanded,
/// and stops before its gripper would sink into something.
///
/// Bodies that nothing can reach in a tick are moved alone. Bodies that may meet form islands (island.hpp), which move
/// one after another, each in as fine steps as its own motion needs.
///
/// A mirror is a body that nothing pushes: it is where the space says, and moves through the tick with its last twist.
#pragma once

#include <utility>
#include <vector>

#include "dynamics2d/crowd_memory.hpp"
#include "dynamics2d/island.hpp"
#include "dynamics2d/rigid_body.hpp"
#include "planar/planar_engine.hpp"

namespace swarmanoid::dynamics2d {

/// Parameters of the engine, which may change live but for `pressure`; SI units.
struct Material {
  int iterations = 1000;                ///< at most, of the solver of an island, in each step
  double gravity = 9.81;                ///< that presses on the plane [m/s2]
  double ground_friction = 0.4;         ///< of what slides
  double treel_friction = 0.9;          ///< of treels
  double contact_friction = 0.3;        ///< between bodies
  double restitution = 0.0;             ///< between bodies
  Pressure pressure = Pressure::kEven;  ///< how weights are spread over what bodies stand on
  double grip_strength = 50.0;          ///< a grip tears beyond it [N]
};

/// A contact as it is shown.
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

  /// How many bodies moved in islands in the last tick; the others were alone.
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
  void finishTick(Space& space, double tick);

  // alone.cpp
  /// What a body may reach in this tick by itself: its own as it is, or its command if that is more.
  struct Rates {
    double speed;  ///< of its centre of mass [m/s]
    double turn;   ///< rad/s
  };
  Rates highestRates(BodyIndex index);
  /// Of any point of its outline [m/s].
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
  /// Two bodies that may meet in a tick. The first one is present; the second one may be what nothing moves.
  using Near = std::pair<BodyIndex, BodyIndex>;
  void findNear();
  void joinIslands();
  int rootOf(int rank);
  void moveIslands(double tick);

  // move_island.cpp
  /// `members_` and `near_of_island_` to `island_`.
  void fillIsland();
  int placeOf(BodyIndex index);
  void addPair(const Near& near);
  /// Whether its bodies hold each other, or may touch in a tick [s] at the speeds that they have or are commanded.
  bool mayTouch(double tick) const;
  /// Whether something in it is held, or slides on the ground.
  bool hasLoad() const;
  /// In how many pieces each step of the island is made in this tick. @param step [s]
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
  /// From `island_` to its bodies, after its last step. @param step that had [s]
  void readIsland(double step);
  void readMotions();
  /// For drawings.
  void noteForces(double step);

  // turret.cpp
  /// Of the island.
  void driveTurrets(double step);
  void turnFreely(planar::Turret& turret, double step);
  double gapAround(const planar::Turret& turret, const PlanarModel& model);
  void turnGripper(const planar::Turret& turret);
  void aimTurret(GripConstraint& grip, double step);
  void readTurret(const GripConstraint& grip, double step);
  void finishTurrets(Space& space);

  // drawing.cpp
  void drawForces(BodyIndex index, EngineDrawing& drawing) const;

  // gripping.cpp
  BodyIndex findGrippable(const Space& space, BodyIndex gripper) const;
  void hold(BodyIndex gripper, BodyIndex gripped);
  void letGo(BodyIndex gripper);
  void forgetGrips(BodyIndex index);
  void takeOverGrips(const Space& space, BodyIndex index);
  /// Of the island. @param time since that was last done [s]
  void tearGrips(double time);

  /// How far any body comes without the others seeing it before it looks around again [m].
  static constexpr double kLookAhead = 0.3;

  Material material_;
  double longest_way_ = 0.0;             // m, of any body in this tick
  double longest_slow_way_ = 0.0;        // m, of those that are not fast
  double travelled_ = 0.0;               // m, no body that was not fast has moved farther since the start
  std::vector<RigidBody> rigid_bodies_;  // by body
  std::vector<BodyIndex> movers_;        // all that the engine moves, by entity number
  std::vector<BodyIndex> present_;       // those of them that something may reach in this tick, by entity number
  std::vector<BodyIndex> mirrors_;       // that may move, by entity number
  std::vector<BodyIndex> grippers_;      // that hold something, by entity number

  std::vector<Near> near_;           // of this tick, by entity numbers
  std::vector<int> roots_;           // by rank: one of the same island, with a lower rank
  std::vector<BodyIndex> members_;   // of the island that moves, by place; then mirrors and what stands
  std::size_t movable_members_ = 0;  // of them
  std::vector<Near> near_of_island_;
  std::vector<std::pair<int, int>> order_of_islands_;  // root and rank of those present
  Island island_;                                      // that moves
  CrowdMemory crowd_memory_;                           // of large islands
  std::vector<DrawnContact> contacts_;                 // of the last steps of this tick
  std::vector<ContactShape> tried_shapes_;             // scratch of gapAround
};

}  // namespace swarmanoid::dynamics2d

/// The three-dimensional dynamic engine (thesis 3.5.3): rigid bodies with masses, forces, friction and gravity, by ODE.
///
/// Wheeled robots stand on treels that drive with no more than the friction they have (treels.hpp). Preys and blocks
/// with a mass are pushed, fall, topple; blocks without one are fixed. Grips are rigid joints that break when pulled
/// too hard: any number of grippers may hold one object, and chains are allowed; a turret turns the grip (turret.hpp).
/// Suction and magnets break in the same way, and also hold fixed entities. Joints move links (arms.hpp), ropes carry
/// the bodies that hang on them (rope.hpp). Flying robots fly by thrust and drag (flight.hpp); without a flight
/// controller they fall. An entity that another engine moves is a mirror: it continues from its pose at the start of
/// the tick with the twist that it had then; nothing stops it, and it pushes other bodies away.
///
/// ODE's bodies have their origin in the centre of mass; poses and twists in the space are of the entities' origins.
/// Entities at rest on the ground keep their height to a few micrometres.
///
/// ODE's exact solver sometimes gives up where contacts tie. Such a step is repeated a few times with ties broken in
/// other ways, then by the iterative solver; so no step leaves contacts without force. The first tick of a run in which
/// the iterative solver had to help has an event (kEngineTrouble); afterwards it is only counted.
///
/// Islands that only contacts connect have a solver of their own; large islands with grips, ropes or links go to the
/// iterative solver (islands.hpp).
///
/// Bodies in steady motion or at rest, without neighbours, are moved without ODE (steady_motion.hpp).
///
/// Terrain is ground like the level ground, and replaces it in its rectangle (ground_contacts.hpp).
///
/// Rays hit the entities' shapes at their poses after the last tick. They do not hit mirrors: the engine that moves the
/// entity reports those hits. Rays do not use ODE, so any number of threads may cast them.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "dynamics3d/body.hpp"
#include "dynamics3d/bounds.hpp"
#include "dynamics3d/contacts/contacts.hpp"
#include "dynamics3d/solver/islands.hpp"
#include "swarmanoid_space/engine.hpp"

namespace swarmanoid::dynamics3d {

class Dynamics3d final : public Engine {
 public:
  /// Counts of the solver since the world was made or cleared.
  struct SolverCounts {
    std::uint64_t steps = 0;
    std::uint64_t moved = 0;            ///< bodies moved by forces in these steps; the others moved steadily
    std::uint64_t redone = 0;           ///< steps in which the exact solver gave up at least once
    std::uint64_t corrected = 0;        ///< solutions repeated because friction did not oppose the slip
    std::uint64_t corrected_ropes = 0;  ///< solutions repeated to close ropes and hinges
    std::uint64_t iterative = 0;        ///< redone steps that the iterative solver made in the end
    std::uint64_t large = 0;            ///< steps with islands that are too large for an exact solution
  };

  static PluginDescription describe();

  Dynamics3d() = default;
  ~Dynamics3d() override;
  Dynamics3d(const Dynamics3d&) = delete;
  Dynamics3d& operator=(const Dynamics3d&) = delete;

  void configure(const std::string& id, const Configuration& parameters) override;
  void reconfigure(const Configuration& parameters) override;
  void prepare(const EngineResources& resources) override;
  std::string unsupportedClocktickReason(Duration clocktick) const override;
  std::string unsupportedReason(const EntityModel& model, const std::vector<DeviceUse>& devices) const override;
  std::string invalidPoseReason(const EntityModel& model, const Pose& pose) const override;
  using Engine::overlap;
  Row overlap(const EntityModel& model, const Pose& pose, Span<const Row> ignored) const override;
  std::string unsupportedStateReason(const Space& space, Row row) const override;
  void add(const Space& space, Row row, Role role) override;
  void remove(const Space& space, Row row) override;
  void place(const Space& space, Row row) override;
  void clear() override;
  void readMirrors(const Space& space) override;
  void move(const Space& space, const MoveAccess& access, Duration dt) override;
  void connect(const Space& space, const ConnectAccess& access) override;
  bool mayHit(const RayBundle& rays) const override;
  void raycast(const RayBundle& rays, Span<RayHit> hits) const override;
  bool blocks(Row row, const RayBundle& ray) const override;
  void draw(EngineDrawing& drawing) const override;
  EngineHealth health() const override;
  double gravity() const override { return settings_.gravity; }
  const SolverCounts& solverCounts() const { return counts_; }

  /// Records the treels of all robots that have them, from now on, by step and entity number; null: stops. For
  /// comparisons with theory.
  void record(std::vector<Treels>* treels) { recorded_treels_ = treels; }
  /// Whether ODE also moves bodies in steady motion, from now on. For comparisons, too.
  void keepInOde(bool keeps_all) { keeps_all_in_ode_ = keeps_all; }

 private:
  Body* find(Row row) const { return by_row_.has(row) ? by_row_[row].get() : nullptr; }
  void makeWorld();
  void destroyWorld();
  /// Sets the ranks, which are positions in `order_`, from `first` on; the ranks before it are valid.
  void rankFrom(std::vector<Body*>::iterator first);
  void takePose(const Space& space, Body& body);

  // motion.cpp
  /// Leaves bodies in steady motion out of ODE for the tick that begins.
  void leaveOutSteady(double tick);
  /// Takes bodies with a neighbour in again. @param steps number of finished steps of this tick
  void takeInReached(int steps, double step);
  void takeIn(Body& body, int steps, double step);
  /// Keeps bodies held by a rope out of steady motion: ropes are not lasting joints in ODE.
  void noteRopes();
  /// @param number of the step in the tick, from 0
  void stepOnce(int number, double step);
  void setDamping(bool is_damped);
  void finishTick(const MoveAccess& access);
  void reportTrouble(const ConnectAccess& access);

  // solving.cpp: each solver moves the bodies that are enabled
  void solveByIslands(double step);
  /// Solves small islands exactly, then the others.
  void solveSmall(double step);
  /// @return false if the solver gave up; small islands are then back in the state before the step
  bool solveExactly(double step);
  bool solveContacts(double step);
  /// Solves enabled islands by the contact solver and ODE's iterative solver.
  void solveOthers(double step);
  bool correctFriction(double step);
  void finishSolution();
  bool correctRopes(double step);
  /// Solves small islands again that `mark_astray` marks. @param most limit of repetitions @param count counts these
  /// solutions @return false if the solver gave up
  template <class MarkAstray>
  bool correct(double step, int most, std::uint64_t& count, MarkAstray mark_astray);
  void markAstrayRopes(double step);
  void restoreStates();
  void makeRopeJoints(double step);

  // attaching.cpp
  struct Surface {
    Body* body = nullptr;
    Eigen::Vector3d point = Eigen::Vector3d::Zero();  // in W
    bool can_be_held = false;
  };
  double strengthOf(EntityModel::Holder::Kind kind) const;
  Surface findSurface(const Body& robot, const Segment& segment, bool is_magnetic) const;
  void connectAttachments(const Space& space, const ConnectAccess& access, Body& robot);
  void connectHold(const Space& space, const ConnectAccess& access, Body& robot, std::size_t holder);
  void connectRope(const Space& space, const ConnectAccess& access, Body& robot, std::size_t holder, double dt);
  void attach(const Space& space, const ConnectAccess& access, Body& robot, std::size_t holder, const Surface& surface,
              double length);
  void hold(Body& robot, std::size_t holder, Body& object, const Attachment& attachment);
  void detach(const Space& space, const ConnectAccess& access, Body& robot, std::size_t holder, const std::string& why);
  void takeOverAttachments(const Space& space, Body& body);
  static void reportForces(const ConnectAccess& access, const Body& robot);
  void drawAttachments(EngineDrawing& drawing) const;  // drawing.cpp

  // gripping.cpp
  Body* findInReach(const Space& space, const Body& robot) const;
  void grip(const Space& space, const ConnectAccess& access, Body& robot, Body& object);
  void joinGripper(Body& robot, Body& object);
  void join(Grip& grip, Body& object);
  void takeOverGrips(const Space& space, Body& body);
  void release(const Space& space, const ConnectAccess& access, Body& robot, const std::string& why);
  static void letGo(Grip& grip);
  /// Releases the holders of the body, and those of others that hold it.
  void forgetHolds(Body& body);
  void feelGrips(double step);

  Settings settings_;
  GroundSurface ground_;
  unsigned long seed_ = 0;  // random seed of this world, in ODE
  dWorldID world_ = nullptr;
  Touches touches_;
  Contacts contacts_;
  Islands islands_;
  RowMap<std::unique_ptr<Body>> by_row_;
  std::vector<Body*> order_;        // by entity number
  SortedBounds<const Body*> seen_;  // for rays and overlap
  std::vector<Body*> left_out_;     // of ODE, in the current tick; includes those taken in again
  int settling_ = 0;                // steps until placed bodies have settled
  SolverCounts counts_;
  bool has_reported_trouble_ = false;
  bool has_reported_islands_ = false;
  std::vector<Treels>* recorded_treels_ = nullptr;
  bool keeps_all_in_ode_ = false;
};

}  // namespace swarmanoid::dynamics3d

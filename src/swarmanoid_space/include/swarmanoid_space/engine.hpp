/// The base class of physics engines (thesis 3.5). An engine moves the entities that it is given, casts rays against
/// them, and gives them back.
///
/// Engines are closed worlds: entities of different engines do not collide. An engine may use its own frame and
/// dimension internally; everything that it reads from the space or writes to it is in W. It may read anything in the
/// space. It writes only `pose`, `twist`, `joints` and `wheel_turns` of the entities that it moves (in `move`), and the
/// structural tree, attachments and events (in `connect`).
///
/// Phases   configure, reconfigure, takeTerrain, add, remove, place, clear: between ticks. readMirrors, move: `move`.
///          connect: `connect`. mayHit, findObstacles, raycast, castRayAt, draw, health: any time except during `move`.
/// Threads  engines move concurrently; mayHit, findObstacles, raycast and castRayAt are called from many threads.
/// Repeats  the same calls give the same bits.
///
/// Handover (thesis chapter 5)
///          Another engine takes over an entity and all entities connected to it. `unsupportedReason`,
///          `invalidPoseReason`, `overlap`, `unsupportedGripReason` and `unsupportedStateReason` decide first, without
///          any change. Then the old engine gets `remove` for each member and the new one `add`, parents before
///          children. Meanwhile the space keeps pose, twist, joints, grips, attachments, devices and everything else.
///          An engine recomputes all other state of its own from these.
///
/// To add an engine: derive, register with REGISTER_ENGINE, and state the limits of its simulation in
/// `unsupportedReason`.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "swarmanoid_interface/configuration.hpp"
#include "swarmanoid_interface/device_type.hpp"
#include "swarmanoid_interface/registry.hpp"
#include "swarmanoid_interface/span.hpp"
#include "swarmanoid_interface/time.hpp"
#include "swarmanoid_space/engine_drawing.hpp"
#include "swarmanoid_space/experiment/experiment.hpp"
#include "swarmanoid_space/rays/obstacles.hpp"
#include "swarmanoid_space/rays/ray.hpp"
#include "swarmanoid_space/rays/terrain.hpp"

namespace swarmanoid {

class Parallel;
class Space;

/// What an engine reports about its own work. It is not part of the state: nothing in the run may depend on it.
struct EngineHealth {
  int steps_per_tick = 1;
  std::string warning;                                        ///< for users; "": no problem
  std::vector<std::pair<std::string, std::string>> counters;  ///< name and value, since the start of the run
};

/// A device of a controller, and the robot's mechanisms that it uses.
struct DeviceUse {
  std::string type;
  std::vector<Mechanism> mechanisms;
  DeviceKind kind = DeviceKind::kSensor;  ///< an actuator commands its mechanisms
};

class Engine {
 public:
  virtual ~Engine() = default;

  /// @throws ConfigError
  virtual void configure(const std::string& id, const Configuration& parameters) = 0;

  /// Takes new values of the parameters that its description marks as live; all other values are those of `configure`.
  /// Called between ticks, with entities in place; the values act from the next tick on.
  /// @throws ConfigError; the engine then keeps the old values
  virtual void reconfigure(const Configuration& /*parameters*/) {}

  /// Reason why this engine cannot run with ticks of that length; "" if it can. Called once, before entities are added.
  virtual std::string unsupportedClocktickReason(Duration /*clocktick*/) const { return ""; }

  /// Sets the heightfield; null: level ground. Called once, before entities are added; it stays after `clear`. Engines
  /// that move entities in a plane ignore it.
  virtual void takeTerrain(const std::shared_ptr<const Terrain>& /*terrain*/) {}

  /// Sets the threads that `move` may use. Called once, before entities are added; they outlive the entities.
  virtual void takeWorkers(const Parallel& /*workers*/) {}

  /// Reason why this engine cannot simulate an entity of this model with these devices; "" if it can. The text names
  /// the unsupported device or property. @param devices of the controller
  virtual std::string unsupportedReason(const EntityModel& model, const std::vector<DeviceUse>& devices) const = 0;

  /// Whether a robot may be moved here although this engine does not support one of its devices. The device is then
  /// idle. This requires that another engine that holds the robot can simulate the device. Example: the rope of a
  /// climbing robot, while other robots carry it over the ground (thesis chapter 5).
  virtual bool mayStandIdle(const EntityModel& /*model*/, const DeviceUse& /*device*/) const { return false; }

  /// Reason why an entity cannot be at that pose, such as "is not in the plane z = 0"; "" if it can. Ignores overlap.
  virtual std::string invalidPoseReason(const EntityModel& model, const Pose& pose) const = 0;

  /// An entity of this engine that a new one at that pose would overlap; kNoRow if there is none.
  /// @param ignored entities that it may overlap, such as itself and the entities connected to it
  virtual Row overlap(const EntityModel& model, const Pose& pose, Span<const Row> ignored) const = 0;
  Row overlap(const EntityModel& model, const Pose& pose, Row ignored) const {
    return overlap(model, pose, Span<const Row>(&ignored, 1));
  }

  /// Reason why this engine could not hold the grip of `gripper` in `structure` if it moved the whole structure; "" if
  /// it can. Called before a handover. The default supports no grips.
  virtual std::string unsupportedGripReason(const Space& /*space*/, Row /*gripper*/) const {
    return "grips, and this engine holds no grips";
  }

  /// The same for the rest of an entity's state: its attachments (`attachments`) and the angles of its joints.
  virtual std::string unsupportedStateReason(const Space& space, Row row) const;

  /// Starts to move or mirror an entity, with the pose and twist that it has in the space; its devices exist already. A
  /// grip in `structure` acts in this engine as soon as both of its ends are moved here. The same holds for
  /// attachments, whose other end may be fixed. @pre the pose is valid, no overlap
  virtual void add(Space& space, Row row, Role role) = 0;
  /// Gives an entity back; its pose and twist in the space are already up to date. Grips in `structure` stay, for the
  /// next engine of the entity.
  virtual void remove(Space& space, Row row) = 0;
  /// Reads the pose of an entity that was set from outside, or of a mirror just before entities are handed over to this
  /// engine. @pre the pose is valid, no overlap, unless it is a mirror
  virtual void place(Space& space, Row row) = 0;
  /// Gives all entities back.
  virtual void clear() = 0;

  /// Moves mirrors to their poses in the space. All engines do this before the first of them moves an entity. So, for
  /// any order of engines and any number of threads, a mirror is at the pose that its entity had at the start of the
  /// tick. Engines without mirrors need not override it.
  virtual void readMirrors(const Space& /*space*/) {}
  /// Simulates one tick of `dt`, in as many steps as the engine's subclock says.
  virtual void move(Space& space, Duration dt) = 0;
  /// Makes and breaks grips from the actuation of this tick.
  virtual void connect(Space& space) = 0;

  /// Whether a ray of the bundle could hit anything in this engine; in doubt, true. Does not read the segments, so a
  /// caller may make them after this check.
  virtual bool mayHit(const RayBundle& rays) const = 0;
  /// Finds the solids that the bundle could hit in this engine, also without reading the segments. The default reports
  /// obstacles anywhere if mayHit is true.
  virtual void findObstacles(const RayBundle& rays, Obstacles& found) const;
  /// Replaces the hit of each segment that hits an entity of this engine nearer than its entry in `hits`.
  virtual void raycast(const RayBundle& rays, Span<RayHit> hits) const = 0;
  /// The same for one segment and one solid that findObstacles has found. @pre no entity has moved since
  virtual void castRayAt(const Obstacles::Solid& solid, const Segment& segment, RayHit& hit) const;
  /// Whether a ray hits that entity. The default casts the ray against all entities of the engine, and returns whether
  /// it hits any of them. For callers that know the possible obstacles: a check of one entity costs a fraction of a
  /// search for neighbours. @param ray of one segment @pre this engine moves the entity
  virtual bool blocks(Row row, const RayBundle& ray) const;
  /// Whether rays hit prisms. A prism may protrude from the upright cylinder around its solid, up to the corners of the
  /// square around that cylinder; nothing that rays hit may protrude farther. Rays of an engine with solids hit an
  /// upright cylinder of a model at its actual place. Lines of sight rely on both.
  virtual bool hitsPrisms() const { return false; }

  /// The gravity that acts on its entities in the next tick, downwards [m/s2]; an inertial unit at rest reads it. An
  /// engine without gravity returns that of the Earth.
  virtual double gravity() const { return kUsualGravity; }
  static constexpr double kUsualGravity = 9.81;  ///< also for entities that no engine moves [m/s2]

  /// Draws the internal state of the engine. Allocates; called on request only.
  virtual void draw(EngineDrawing& /*drawing*/) const {}

  /// Returns the state of the engine as text and counters; also on request only.
  virtual EngineHealth health() const { return {}; }

  const std::string& id() const { return id_; }

 protected:
  std::string id_;
};

}  // namespace swarmanoid

/// Registers an engine; place it at the end of the source. `Class` has a static function
/// `PluginDescription describe()`.
#define REGISTER_ENGINE(Class)                                                                \
  namespace {                                                                                 \
  const ::swarmanoid::PluginRegistration<::swarmanoid::Engine, Class> SWARMANOID_CONCATENATE( \
      registration_, __COUNTER__)(::swarmanoid::PluginKind::kEngine, Class::describe());      \
  }

/// The base class of physics engines (thesis 3.5). An engine moves the entities that it is given, casts rays against
/// them, and gives them back.
///
/// Engines are closed worlds: entities of different engines do not collide. An engine may use its own frame and
/// dimension internally; everything that it reads from the space or writes to it is in W. It may read anything in the
/// space. It writes only the members of MoveAccess and ConnectAccess (access.hpp), for the entities that it moves.
///
/// Phases   configure, reconfigure, prepare, add, remove, place, clear, archive: between ticks.
///          readMirrors, move: `move`.
///          connect: `connect`. draw, health: any time except during `move`.
/// Threads  engines move concurrently; rays are cast from many threads.
/// Repeats  the same calls give the same bits.
///
/// Handover (thesis chapter 5)
///          Another engine takes over an entity and all entities connected to it. The functions of EngineLimits decide
///          first, without any change. Then the old engine gets `remove` for each member and the new one `add`, parents
///          before children. Meanwhile the space keeps pose, twist, joints, grips, attachments, devices and everything
///          else. An engine recomputes all other state of its own from these.
///
/// To add an engine: derive, register with REGISTER_ENGINE, and state the limits of its simulation by the functions of
/// EngineLimits.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "swarmanoid_interface/configuration.hpp"
#include "swarmanoid_interface/device_type.hpp"
#include "swarmanoid_interface/registry.hpp"
#include "swarmanoid_interface/span.hpp"
#include "swarmanoid_interface/state_archive.hpp"
#include "swarmanoid_interface/time.hpp"
#include "swarmanoid_space/engine_drawing.hpp"
#include "swarmanoid_space/engine_limits.hpp"
#include "swarmanoid_space/experiment/experiment.hpp"
#include "swarmanoid_space/rays/ray_target.hpp"
#include "swarmanoid_space/rays/terrain.hpp"

namespace swarmanoid {

class Parallel;
class Space;
struct ConnectAccess;
struct MoveAccess;

/// What an engine reports about its own work. It is not part of the state: nothing in the run may depend on it.
struct EngineHealth {
  int steps_per_tick = 1;
  std::string warning;                                        ///< for users; "": no problem
  std::vector<std::pair<std::string, std::string>> counters;  ///< name and value, since the start of the run
};

/// The ground and the threads of an engine.
struct EngineResources {
  std::shared_ptr<const Terrain> terrain;  ///< the heightfield; null: level ground
  const Parallel* workers = nullptr;       ///< threads that `move` may use; they outlive the entities. Null: none
};

class Engine : public EngineLimits, public RayTarget {
 public:
  /// @throws ConfigError
  virtual void configure(const std::string& id, const Configuration& parameters) = 0;

  /// Takes new values of the parameters that its description marks as live; all other values are those of `configure`.
  /// Called between ticks, with entities in place; the values act from the next tick on.
  /// @throws ConfigError; the engine then keeps the old values
  virtual void reconfigure(const Configuration& /*parameters*/) {}

  /// Called once after `configure`, before entities are added. The engine keeps these values, also after `clear`. The
  /// default ignores them.
  virtual void prepare(const EngineResources& /*resources*/) {}

  /// Starts to move or mirror an entity, with the pose and twist that it has in the space; its devices exist already. A
  /// grip in `structure` acts in this engine as soon as both of its ends are moved here. The same holds for
  /// attachments, whose other end may be fixed. @pre the pose is valid, no overlap
  virtual void add(const Space& space, Row row, Role role) = 0;
  /// Gives an entity back; its pose and twist in the space are already up to date. Grips in `structure` stay, for the
  /// next engine of the entity.
  virtual void remove(const Space& space, Row row) = 0;
  /// Reads the pose of an entity that was set from outside, or of a mirror just before entities are handed over to this
  /// engine. @pre the pose is valid, no overlap, unless it is a mirror
  virtual void place(const Space& space, Row row) = 0;
  /// Gives all entities back.
  virtual void clear() = 0;

  /// Moves mirrors to their poses in the space. All engines do this before the first of them moves an entity. So, for
  /// any order of engines and any number of threads, a mirror is at the pose that its entity had at the start of the
  /// tick. Engines without mirrors need not override it.
  virtual void readMirrors(const Space& /*space*/) {}
  /// Simulates one tick of `dt`, in as many steps as the engine's subclock says.
  virtual void move(const Space& space, const MoveAccess& access, Duration dt) = 0;
  /// Makes and breaks grips from the actuation of this tick.
  virtual void connect(const Space& space, const ConnectAccess& access) = 0;

  /// Saves or loads all state of its own that later ticks depend on (state_archive.hpp), for snapshots of a run; not
  /// the parameters. When it loads, the engine has the same entities with the same roles, perhaps added in another
  /// order, and the space has their state already. So values are saved by entity, in the order of entity numbers. The
  /// default declares that the state is not defined: a snapshot is then refused, with the engine's name.
  virtual void archive(const Space& /*space*/, StateArchive& state) { state.refuse(); }

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

/// The base class of physics engines (thesis 3.5): moves the entities it is given, casts rays against them, gives them
/// back.
///
/// Engines are closed worlds: entities of different engines do not collide. An engine keeps its own frame and
/// dimension; what it reads from the space and writes to it is in W. It may read anything in the space, and writes only
/// `pose`, `twist`, `joints` and `wheel_turns` of the entities it moves (in `move`), the structural tree, attachments
/// and events (in `connect`).
///
/// Phases   configure, reconfigure, takeTerrain, add, remove, place, clear: between ticks. readMirrors, move: `move`.
///          connect: `connect`. mayHit, findObstacles, raycast, castRayAt, draw, health: any time but during `move`.
/// Threads  engines move at the same time as each other; mayHit, findObstacles, raycast and castRayAt are called from
///          many threads.
/// Repeats  the same calls give the same bits.
///
/// Handover (thesis chapter 5)
///          an entity changes the engine that moves it, with all that it is connected to: `unsupportedReason`,
///          `invalidPoseReason`, `overlap`, `unsupportedGripReason` and `unsupportedStateReason` decide, without any
///          change; then the old engine gets `remove` for each member and the new one `add`, parents before children.
///          The space keeps pose, twist, joints, grips, attachments, devices and everything else meanwhile, so what an
///          engine has beyond them, it makes anew from them.
///
/// To add an engine: derive, register with REGISTER_ENGINE, write what it can simulate in `unsupportedReason`.
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
#include "swarmanoid_space/experiment_file/experiment.hpp"
#include "swarmanoid_space/rays/obstacles.hpp"
#include "swarmanoid_space/rays/ray.hpp"
#include "swarmanoid_space/rays/terrain.hpp"

namespace swarmanoid {

class Parallel;
class Space;

/// What an engine reports about its own work. Not part of the state: nothing in the run may depend on it.
struct EngineHealth {
  int steps_per_tick = 1;
  std::string warning;                                        ///< for users to read; "": all is well
  std::vector<std::pair<std::string, std::string>> counters;  ///< name and value, since the run began
};

/// A device of a controller, and the mechanisms of the robot that it works with.
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

  /// Takes new values of the parameters that its description marks as live; all others are as in `configure`. Between
  /// ticks, with entities in place: from the next tick on it works with them.
  /// @throws ConfigError; then it keeps the old
  virtual void reconfigure(const Configuration& /*parameters*/) {}

  /// Why this engine cannot run with ticks of that length; "" if it can. Asked once, before entities are added.
  virtual std::string unsupportedClocktickReason(Duration /*clocktick*/) const { return ""; }

  /// The ground that is not level, or null. Given once, before entities are added, and stays over `clear`. Engines that
  /// move things in a plane make nothing of it.
  virtual void takeTerrain(const std::shared_ptr<const Terrain>& /*terrain*/) {}

  /// The threads that `move` may work on. Given once, before entities are added; they stay
  /// as long as there are any.
  virtual void takeWorkers(const Parallel& /*workers*/) {}

  /// What this engine cannot do for such an entity: "" if it can simulate it with these devices, else a text that names
  /// the device or the property. @param devices of the controller
  virtual std::string unsupportedReason(const EntityModel& model, const std::vector<DeviceUse>& devices) const = 0;

  /// Whether a robot with that device, which this engine refuses, may be moved here all the same with the device idle,
  /// if another of the engines that hold the robot can simulate it: such as the rope of a climbing robot while others
  /// carry it over the ground (thesis chapter 5).
  virtual bool mayStandIdle(const EntityModel& /*model*/, const DeviceUse& /*device*/) const { return false; }

  /// Why an entity cannot stand there, such as "is not in the plane z = 0"; "" if it can. Overlap is not looked at.
  virtual std::string invalidPoseReason(const EntityModel& model, const Pose& pose) const = 0;

  /// An entity of this engine that a new one at that pose would overlap; kNoRow if there is none.
  /// @param ignored entities that it may overlap, such as itself and what it is connected to
  virtual Row overlap(const EntityModel& model, const Pose& pose, Span<const Row> ignored) const = 0;
  Row overlap(const EntityModel& model, const Pose& pose, Row ignored) const {
    return overlap(model, pose, Span<const Row>(&ignored, 1));
  }

  /// Why this engine could not hold the grip that `gripper` has in `structure`, if it moved the whole structure; "" if
  /// it can. Asked before a handover. An engine that does not say otherwise holds no grips.
  virtual std::string unsupportedGripReason(const Space& /*space*/, Row /*gripper*/) const {
    return "grips, and this engine holds no grips";
  }

  /// Likewise for the rest of an entity's state: what it holds on to in `attachments`, where its joints are.
  virtual std::string unsupportedStateReason(const Space& space, Row row) const;

  /// Takes charge of an entity at the pose, and with the twist, that it has in the space; its devices are there too. As
  /// soon as both ends of a grip in `structure` are moved here, the grip holds here; likewise attachments, whose other
  /// end may be fixed. @pre the pose is valid, no overlap
  virtual void add(Space& space, Row row, Role role) = 0;
  /// Gives an entity back; its pose and twist in the space are already what they should be. Grips in `structure` stay,
  /// for the engine that gets it next.
  virtual void remove(Space& space, Row row) = 0;
  /// The entity's pose in the space was set from outside; or it is a mirror, and a handover to this engine is to be
  /// decided by where it is now. @pre the pose is valid, no overlap, unless it is a mirror
  virtual void place(Space& space, Row row) = 0;
  /// Gives everything back.
  virtual void clear() = 0;

  /// Puts mirrors where the space says that they are. All engines do so before the first of them moves anything:
  /// whatever the order and the threads, a mirror is where its entity was when the tick began. An engine that makes
  /// nothing of mirrors leaves it as it is.
  virtual void readMirrors(const Space& /*space*/) {}
  /// One tick of `dt`, in as many steps as the engine's subclock says.
  virtual void move(Space& space, Duration dt) = 0;
  /// Makes and breaks grips from the actuation of this tick.
  virtual void connect(Space& space) = 0;

  /// Whether a ray of the bundle could hit anything here; in doubt, yes. The segments are not looked at, so a
  /// caller that asks first need not have made them.
  virtual bool mayHit(const RayBundle& rays) const = 0;
  /// What the bundle could hit here, likewise. An engine that does not say otherwise says that it may be anywhere.
  virtual void findObstacles(const RayBundle& rays, Obstacles& found) const;
  /// For each segment: if it hits an entity of this engine nearer than `hits` says so far, that hit replaces it.
  virtual void raycast(const RayBundle& rays, Span<RayHit> hits) const = 0;
  /// The same for one segment, and one solid that this engine has found (findObstacles). @pre nothing has moved since
  virtual void castRayAt(const Obstacles::Solid& solid, const Segment& segment, RayHit& hit) const;
  /// Whether a ray hits that entity, which this engine moves; an engine that does not say otherwise looks at all that
  /// it holds, and says whether anything is hit. For callers who know what could stand in the way: to look at one
  /// entity costs a fraction of a look-up of what is near. @param ray of one segment @pre this engine moves the entity
  virtual bool blocks(Row row, const RayBundle& ray) const;
  /// Whether rays hit prisms, which may stand out of the upright cylinder around a solid, up to the corners of the
  /// square around that. Nothing that rays hit may stand out farther; and who has solids hits an upright cylinder of a
  /// model where it is. Lines of sight count on both.
  virtual bool hitsPrisms() const { return false; }

  /// The gravity that acts on its entities in the tick to come, downwards [m/s2]: what an inertial unit at rest reads.
  /// An engine without gravity stands for level ground on the Earth.
  virtual double gravity() const { return kUsualGravity; }
  static constexpr double kUsualGravity = 9.81;  ///< also where no engine moves an entity [m/s2]

  /// Shows people what the engine works with. Allocates; called on request only.
  virtual void draw(EngineDrawing& /*drawing*/) const {}

  /// Likewise, in words and numbers.
  virtual EngineHealth health() const { return {}; }

  const std::string& id() const { return id_; }

 protected:
  std::string id_;
};

}  // namespace swarmanoid

/// At the end of an engine's source. `Class` has a static function `PluginDescription describe()`.
#define REGISTER_ENGINE(Class)                                                                \
  namespace {                                                                                 \
  const ::swarmanoid::PluginRegistration<::swarmanoid::Engine, Class> SWARMANOID_CONCATENATE( \
      registration_, __COUNTER__)(::swarmanoid::PluginKind::kEngine, Class::describe());      \
  }

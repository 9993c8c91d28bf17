/// The Swarmanoid Space (thesis 3.4): the state of one world, in parts. Engines, devices, controllers and observers
/// interact only through it.
///
/// Frames: W, the space's own, z up; the arena spans from `corner` by `size`. The ground is at z = 0. SI units.
/// The phase that writes a part is stated beside it; all code may read it in the other phases.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "swarmanoid_interface/color.hpp"
#include "swarmanoid_interface/frames.hpp"
#include "swarmanoid_interface/robot.hpp"
#include "swarmanoid_interface/time.hpp"
#include "swarmanoid_space/engine.hpp"
#include "swarmanoid_space/experiment/experiment.hpp"
#include "swarmanoid_space/index/positional_index.hpp"
#include "swarmanoid_space/intervention.hpp"
#include "swarmanoid_space/metrics.hpp"
#include "swarmanoid_space/rays/entities_without_engine.hpp"
#include "swarmanoid_space/rays/ray.hpp"
#include "swarmanoid_space/rays/terrain.hpp"
#include "swarmanoid_space/state/attachments.hpp"
#include "swarmanoid_space/state/bank.hpp"
#include "swarmanoid_space/state/battery_state.hpp"
#include "swarmanoid_space/state/entities.hpp"
#include "swarmanoid_space/state/event.hpp"
#include "swarmanoid_space/state/floor.hpp"
#include "swarmanoid_space/state/joints.hpp"
#include "swarmanoid_space/state/mechanisms.hpp"
#include "swarmanoid_space/state/overflow.hpp"
#include "swarmanoid_space/state/structural_tree.hpp"

namespace swarmanoid {

/// A bright spot that a laser pointer makes where its beam hits a surface or the floor.
struct LaserSpot {
  EntityNumber owner = kNoEntity;
  Eigen::Vector3d source = Eigen::Vector3d::Zero();    ///< start of the beam, at the pointer [m]
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< end of the beam [m]
  Color color;
};

/// The controller of a robot, and the result of its control step in a tick.
struct ControllerState {
  const ControllerDescription* description = nullptr;  ///< null: the entity has none
  std::uint32_t starts = 0;                            ///< number of its starts, here or in another process
  StepStatus status =
      StepStatus::kNothing;  ///< kNothing: not called, or late; the commands are those of an earlier tick

  void archive(StateArchive& state) { state(starts, status); }
};

/// Visits the name of the engine that moves an entity. It is part of the state hash, so two runs that differ only in
/// the engine have different hashes at once, before their poses differ. Fixed entities, such as walls, are skipped:
/// they may be in several engines, and no engine moves them.
void visitCell(StateVisitor& visitor, const char* name, const CellOwner& owner, const Engine* mover);

class Space {
 public:
  Space() = default;
  Space(const Space&) = delete;
  Space& operator=(const Space&) = delete;

  // The clock. `tick` counts finished ticks; `time` is that of the current tick, epoch + tick * clocktick.
  std::uint64_t tick = 0;
  std::uint64_t run = 0;  ///< counts resets
  Duration clocktick{};
  Time time = kEpoch;
  Duration time_before_reset{};  ///< added to `time` for clocks that never go back (ROS)
  std::uint64_t seed = 1;

  // The arena, constant during a run.
  Eigen::Vector3d corner = Eigen::Vector3d::Zero();  ///< with the least coordinates [m]
  Eigen::Vector3d size = Eigen::Vector3d::Ones();    ///< [m]
  Eigen::Vector3d farCorner() const { return corner + size; }
  Floor floor;
  std::shared_ptr<const Terrain> terrain;  ///< null: the floor is level
  /// The lowest ground [m]: 0, or less where a terrain has holes.
  double lowestGround() const { return terrain ? std::min(0.0, terrain->bounds().min().z()) : 0.0; }
  /// The hole of the floor above, on or below which the point lies; null if there is none. Inside a terrain the terrain
  /// is the ground, and floor holes do not count. Inline, since sensors call it often.
  const FloorHole* holeAt(const Eigen::Vector3d& point) const {
    for (const FloorHole& hole : floor.holes) {
      if (hole.contains(point)) {
        return terrain && terrain->contains(point.x(), point.y()) ? nullptr : &hole;
      }
    }
    return nullptr;
  }

  // The world. Data with one value per entity are columns (state/column.hpp), which name the phase that writes them.
  Entities entities;
  /// The colours of the LEDs of the model, LED 0 first.
  ListColumn<Color, WrittenIn::kActuate> leds{
      entities.columns, {"led", Visits::kHash}, [](const EntityModel& model) { return model.led_positions.size(); }};
  StructuralTree structure{entities.columns};
  /// The joints of the model, in its order.
  ListColumn<JointState, WrittenIn::kMove> joints{
      entities.columns, {"joint", Visits::kHash}, [](const EntityModel& model) { return model.joints.size(); }};
  /// Follows from the commands, so it is not in the state hash; readings derived from it are in the deep hash.
  Column<WheelTurns, WrittenIn::kMove | WrittenIn::kConnect> wheel_turns{entities.columns, {"wheel_turns"}};
  Attachments attachments{entities};
  /// The properties of the model, in its order. Writers of radio tags change the data of tags (kTagData) in `actuate`;
  /// `power` writes the properties of robots with a battery.
  ListColumn<double, WrittenIn::kActuate | WrittenIn::kPower> properties{
      entities.columns,
      {"property", Visits::kHash},
      [](const EntityModel& model) { return model.properties.size(); },
      [](const EntityModel& model, std::size_t place) { return model.properties[place].initial; }};
  /// A look-up by name, for sensors, once per entity: few models have properties, and these have few names to compare.
  /// @return nothing if the entity has no such property
  std::optional<double> property(Row row, std::string_view name) const;
  /// One value for a robot with a battery, none for other entities.
  ListColumn<BatteryState, WrittenIn::kPower> batteries{
      entities.columns, {"battery", Visits::kHash}, [](const EntityModel& model) {
        return std::size_t{model.battery ? 1U : 0U};
      }};
  /// The colour of the entity's own surface or light as cameras see it; black for a lamp of kIntensity 0.
  Color ownColor(Row row) const;

  // Commands of the robots' mechanisms; joints and holders in the order of the model.
  Column<WheelsCommand, WrittenIn::kActuate> wheels{entities.columns, {"wheels"}};
  Column<FlightCommand, WrittenIn::kActuate> flight{entities.columns, {"flight"}};
  ListColumn<JointCommand, WrittenIn::kActuate> joint_commands{
      entities.columns, {"joint_command"}, [](const EntityModel& model) { return model.joints.size(); }};
  ListColumn<HolderCommand, WrittenIn::kActuate> holder_commands{
      entities.columns, {"holder_command"}, [](const EntityModel& model) { return model.holders.size(); }};

  /// First tick after the last teleport (start, spawn, move). Readings that compare two ticks are undefined in it.
  Column<std::uint64_t> placed{entities.columns, {"placed"}};
  /// null: no engine moves the entity
  Column<const Engine*, WrittenIn::kConnect> mover{entities.columns, {"engine", Visits::kHash}};
  /// 1: the entity's origin is outside the arena
  Column<char, WrittenIn::kIndex> outside{entities.columns, {"outside", Visits::kRecordings}};
  /// null: the entity has no controller
  Column<std::unique_ptr<Robot>> robots{entities.columns, {"robot"}};
  /// Written in `control`; a failure also in `actuate`.
  Column<ControllerState, WrittenIn::kControl | WrittenIn::kActuate> controllers{entities.columns, {"controller"}};

  PositionalIndex index;               ///< index; the state at the end of the last tick
  std::vector<LaserSpot> laser_spots;  ///< connect; in the order of actuators, then of entities
  std::vector<Event> events;           ///< of this tick, in the order in which they happened
  /// Interventions carried out since the last tick, in order.
  std::vector<TakenIntervention> interventions;
  std::vector<const Metric*> metrics;  ///< rule; of all rules, in their order
  std::vector<Overflow> overflows;     ///< sense; of the run, ordered by first tick

  // Devices, by type (bank.hpp).
  Banks readings;   ///< sense
  Banks commands;   ///< control
  Banks actuation;  ///< actuate

  std::vector<const Engine*> engines;  ///< all, in the order of the experiment file

  /// Whether a ray of the bundle could hit anything; in doubt, true. Does not read its segments. Far cheaper than
  /// casting. Thread-safe outside `move`.
  bool mayHit(const RayBundle& rays) const;
  /// The obstacles that the rays of the bundle could hit; a segment that misses all of them hits nothing. Does not read
  /// the segments either. Thread-safe outside `move`.
  Obstacles findObstacles(const RayBundle& rays) const;
  /// Casts rays against everything: the terrain, all engines, and entities without an engine. Returns the closest hit
  /// of each segment. Thread-safe outside `move`.
  void raycast(const RayBundle& rays, Span<RayHit> hits) const;
  /// Casts a segment against one solid that `findObstacles` has found. A hit that is nearer than `hit` replaces it.
  /// Thread-safe outside `move`.
  void castRayAt(const Obstacles::Solid& solid, const Segment& segment, RayHit& hit) const {
    if (solid.engine != nullptr) {
      solid.engine->castRayAt(solid, segment, hit);
    } else {
      entities_without_engine.castRayAt(entities, solid.row, segment, hit);
    }
  }
  /// Casts one ray, ignoring up to two entities.
  RayHit castRay(const Segment& segment, Row ignored = kNoRow, Row also_ignored = kNoRow) const;
  /// Whether an entity other than the two, or the terrain, is between the points (thesis 3.4, "physical occlusions").
  bool isOccluded(const Segment& segment, Row from, Row to) const;

  /// Maintained by the code that adds, removes and moves entities.
  EntitiesWithoutEngine entities_without_engine;
  /// Robots with a battery, by entity number; maintained by the same code.
  std::vector<Row> powered;
};

/// Passes all named state to the visitor: the columns in the order of entity numbers, then the state of the world.
void visitState(const Space& space, StateVisitor& visitor);

/// A hash of all named state (XXH3): the clock, the hashed columns, changed colours, laser spots, paint.
/// Equal hashes in each tick mean equal runs; -0 counts as 0.
std::uint64_t stateHash(const Space& space);

/// A hash of the state and of all readings and commands, bit for bit. It differs in the tick in which a device differs,
/// even before the state does. Allocates.
std::uint64_t deepHash(const Space& space);

}  // namespace swarmanoid

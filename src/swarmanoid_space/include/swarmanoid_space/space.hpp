/// The Swarmanoid Space (thesis 3.4): the state of one world, in parts. Engines, devices, controllers and
/// observers meet only here.
///
/// Frames: W, the space's own, z up; the arena spans from `corner` by `size`. The ground is at z = 0. SI units.
/// Which phase writes a part stands beside it; all may read it in the other phases.
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
#include "swarmanoid_space/experiment_file/experiment.hpp"
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
  Eigen::Vector3d source = Eigen::Vector3d::Zero();    ///< where the beam leaves the pointer [m]
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< where it ends [m]
  Color color;
};

/// The controller of a robot, and what came of its control step in a tick.
struct ControllerState {
  const ControllerDescription* description = nullptr;  ///< null: the entity has none
  std::uint32_t starts = 0;                            ///< how often it was started, here or in another process
  StepStatus status =
      StepStatus::kNothing;  ///< kNothing: not asked, or late; the commands are those of an earlier tick
};

/// The engine that moves an entity is part of the state hash, by its name: two runs that differ only in it have
/// different hashes at once, before their poses differ. Walls may be in several engines, and none moves them.
void visitCell(StateVisitor& visitor, const char* name, const CellOwner& owner, const Engine* mover);

class Space {
 public:
  Space() = default;
  Space(const Space&) = delete;
  Space& operator=(const Space&) = delete;

  // The clock. `tick` counts finished ticks; `time` is that of the tick under way, epoch + tick * clocktick.
  std::uint64_t tick = 0;
  std::uint64_t run = 0;  ///< counts resets
  Duration clocktick{};
  Time time = kEpoch;
  Duration time_before_reset{};  ///< added to `time` by whoever needs a clock that never goes back (ROS)
  std::uint64_t seed = 1;

  // The arena, fixed while it runs.
  Eigen::Vector3d corner = Eigen::Vector3d::Zero();  ///< with the least coordinates [m]
  Eigen::Vector3d size = Eigen::Vector3d::Ones();    ///< [m]
  Eigen::Vector3d farCorner() const { return corner + size; }
  Floor floor;
  std::shared_ptr<const Terrain> terrain;  ///< null: the floor is level
  /// The lowest ground [m]: 0, or less where a terrain has holes.
  double lowestGround() const { return terrain ? std::min(0.0, terrain->bounds().min().z()) : 0.0; }
  /// The hole of the floor above, on or below which the point lies; null if there is none. Where there is a terrain,
  /// that is the ground, and has no holes but its own. In the header, since sensors ask for it often.
  const FloorHole* holeAt(const Eigen::Vector3d& point) const {
    for (const FloorHole& hole : floor.holes) {
      if (hole.contains(point)) {
        return terrain && terrain->contains(point.x(), point.y()) ? nullptr : &hole;
      }
    }
    return nullptr;
  }

  // The world. What has one value an entity is a column (state/column.hpp), and says itself who writes it.
  Entities entities;
  /// The colours of the LEDs of the model, LED 0 first.
  ListColumn<Color> leds{entities.columns, {"led", Writer::kActuate, Visits::kHash}, [](const EntityModel& model) {
                           return model.led_positions.size();
                         }};
  StructuralTree structure{entities.columns};
  /// The joints of the model, in its order.
  ListColumn<JointState> joints{entities.columns,
                                {"joint", Writer::kMove, Visits::kHash},
                                [](const EntityModel& model) { return model.joints.size(); }};
  /// Follows from the commands, so it is not in the hash; readings that follow from it are in the deep hash.
  Column<WheelTurns> wheel_turns{entities.columns, {"wheel_turns", Writer::kMove}};
  Attachments attachments{entities};
  /// The properties of the model, in its order. In `actuate`, writers of radio tags change what these hold (kTagData);
  /// `power` writes those of robots with a battery.
  ListColumn<double> properties{
      entities.columns,
      {"property", Writer::kBetweenTicks, Visits::kHash},
      [](const EntityModel& model) { return model.properties.size(); },
      [](const EntityModel& model, std::size_t place) { return model.properties[place].initial; }};
  /// For sensors, once an entity: few models have properties, and those that have, have few names to compare.
  /// @return nothing if the entity has no such property
  std::optional<double> property(Row row, std::string_view name) const;
  /// One for each robot that has a battery, none for what has none.
  ListColumn<BatteryState> batteries{entities.columns,
                                     {"battery", Writer::kPower, Visits::kHash},
                                     [](const EntityModel& model) { return std::size_t{model.battery ? 1U : 0U}; }};
  /// The colour of the entity's own surface or light as cameras see it; a lamp of kIntensity 0 is black.
  Color ownColor(Row row) const;

  // What the mechanisms of robots are commanded to do; joints and holders in the order of the model.
  Column<WheelsCommand> wheels{entities.columns, {"wheels", Writer::kActuate}};
  Column<FlightCommand> flight{entities.columns, {"flight", Writer::kActuate}};
  ListColumn<JointCommand> joint_commands{entities.columns,
                                          {"joint_command", Writer::kActuate},
                                          [](const EntityModel& model) { return model.joints.size(); }};
  ListColumn<HolderCommand> holder_commands{entities.columns,
                                            {"holder_command", Writer::kActuate},
                                            [](const EntityModel& model) { return model.holders.size(); }};

  /// The tick that was to come when the entity was put where it is from outside: at the start, spawned or moved. What
  /// compares ticks has nothing to compare that one with.
  Column<std::uint64_t> placed{entities.columns, {"placed", Writer::kBetweenTicks}};
  /// null: no engine moves the entity
  Column<Engine*> mover{entities.columns, {"engine", Writer::kConnect, Visits::kHash}};
  /// 1: the entity's origin is outside the arena
  Column<char> outside{entities.columns, {"outside", Writer::kIndex, Visits::kRecordings}};
  /// null: the entity has no controller
  Column<std::unique_ptr<Robot>> robots{entities.columns, {"robot", Writer::kBetweenTicks}};
  /// control; a failure also actuate
  Column<ControllerState> controllers{entities.columns, {"controller", Writer::kControl}};

  PositionalIndex index;               ///< index; as of the end of the last tick
  std::vector<LaserSpot> laser_spots;  ///< connect; by the order of actuators, then of entities
  std::vector<Event> events;           ///< of this tick, in order of happening
  /// Carried out since the last tick, in that order.
  std::vector<TakenIntervention> interventions;
  std::vector<const Metric*> metrics;  ///< rule; of all rules, in their order
  std::vector<Overflow> overflows;     ///< sense; of the run, by their first ticks

  // Devices, by type (bank.hpp).
  Banks readings;   ///< sense
  Banks commands;   ///< control
  Banks actuation;  ///< actuate

  std::vector<Engine*> engines;  ///< all, in the order of the experiment file

  /// Whether a ray of the bundle could hit anything; in doubt, yes. Its segments are not looked at. Far cheaper than
  /// casting. Thread-safe outside `move`.
  bool mayHit(const RayBundle& rays) const;
  /// What the rays of the bundle could hit, likewise: a segment that passes by none of it hits nothing.
  Obstacles findObstacles(const RayBundle& rays) const;
  /// Casts rays against everything: the terrain, all engines, and entities in no engine. For each segment the nearest
  /// hit.
  /// Thread-safe outside `move`.
  void raycast(const RayBundle& rays, Span<RayHit> hits) const;
  /// Casts a segment against one solid that `findObstacles` has found. A hit that is nearer than `hit` replaces it.
  /// Likewise thread-safe.
  void castRayAt(const Obstacles::Solid& solid, const Segment& segment, RayHit& hit) const {
    if (solid.engine != nullptr) {
      solid.engine->castRayAt(solid, segment, hit);
    } else {
      entities_without_engine.castRayAt(entities, solid.row, segment, hit);
    }
  }
  /// One ray, through up to two entities.
  RayHit castRay(const Segment& segment, Row ignored = kNoRow, Row also_ignored = kNoRow) const;
  /// Whether something other than the two stands between the points (thesis 3.4, "physical occlusions").
  bool isOccluded(const Segment& segment, Row from, Row to) const;

  /// Kept by those who add, remove and move entities.
  EntitiesWithoutEngine entities_without_engine;
  /// Robots with a battery, by entity number; likewise.
  std::vector<Row> powered;
};

/// Passes all named state to the visitor: the columns in the order of entity numbers, then what belongs to the world.
void visitState(const Space& space, StateVisitor& visitor);

/// A hash of all named state (XXH3): the clock, the columns that are hashed, laser spots.
/// Equal hashes each tick mean equal runs; -0 counts as 0.
std::uint64_t stateHash(const Space& space);

/// A hash of the state and of all readings and commands, bit for bit: it differs in the tick in which a device does,
/// and not only once the state follows. Allocates.
std::uint64_t deepHash(const Space& space);

}  // namespace swarmanoid

/// The Swarmanoid Space (thesis 3.4): the state of one world, in parts. Engines, devices, controllers and
/// observers meet only here.
///
/// Frames: W, the space's own, z up; the arena spans from the origin to `size`. SI units.
/// Which phase writes a part stands beside it; all may read it in the other phases.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstdint>
#include <memory>
#include <vector>

#include "swarmanoid_interface/color.hpp"
#include "swarmanoid_interface/frames.hpp"
#include "swarmanoid_interface/robot.hpp"
#include "swarmanoid_interface/time.hpp"
#include "swarmanoid_space/engine.hpp"
#include "swarmanoid_space/experiment_file/experiment.hpp"
#include "swarmanoid_space/index/positional_index.hpp"
#include "swarmanoid_space/rays/ray.hpp"
#include "swarmanoid_space/rays/terrain.hpp"
#include "swarmanoid_space/state/attachments.hpp"
#include "swarmanoid_space/state/bank.hpp"
#include "swarmanoid_space/state/entities.hpp"
#include "swarmanoid_space/state/event.hpp"
#include "swarmanoid_space/state/joints.hpp"
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
  Eigen::Vector3d size = Eigen::Vector3d::Ones();
  std::vector<FloorPatch> floor_patches;
  std::shared_ptr<const Terrain> terrain;  ///< null: the floor is level
  /// The lowest ground [m]: 0, or less where a terrain has holes.
  double lowestGround() const { return terrain ? std::min(0.0, terrain->bounds().min().z()) : 0.0; }

  // The world.
  Entities entities;               ///< pose, twist: move
  StructuralTree structure;        ///< connect
  Attachments attachments;         ///< connect
  PositionalIndex index;           ///< index; as of the end of the last tick
  std::vector<JointState> joints;  ///< move; rows of EntityModel::kMaxJoints, by entity row: those of model->joints
  /// actuate; rows of EntityModel::kMaxLeds, by entity row: the colours of model->led_positions
  std::vector<Color> leds;
  std::vector<LaserSpot> laser_spots;  ///< connect; by the order of actuators, then of entities
  std::vector<Event> events;           ///< of this tick, in order of happening
  std::vector<Overflow> overflows;     ///< sense; of the run, by their first ticks

  // Devices, by type (bank.hpp).
  Banks readings;   ///< sense
  Banks commands;   ///< control
  Banks actuation;  ///< actuate

  // Who is in charge, by entity row.
  std::vector<Engine*> mover;                  ///< null: no engine moves the entity
  std::vector<std::unique_ptr<Robot>> robots;  ///< null: the entity has no controller
  std::vector<ControllerState> controllers;    ///< control; a failure also actuate
  std::vector<char> outside;                   ///< index; 1: the entity's origin is outside the arena

  std::vector<Engine*> engines;  ///< all, in the order of the experiment file

  /// The states of an entity's joints, EntityModel::kMaxJoints of them.
  JointState* jointsOf(Row row) { return &joints[static_cast<std::size_t>(row) * EntityModel::kMaxJoints]; }
  const JointState* jointsOf(Row row) const { return &joints[static_cast<std::size_t>(row) * EntityModel::kMaxJoints]; }

  /// The colours of an entity's LEDs, EntityModel::kMaxLeds of them.
  Color* ledsOf(Row row) { return &leds[static_cast<std::size_t>(row) * EntityModel::kMaxLeds]; }
  const Color* ledsOf(Row row) const { return &leds[static_cast<std::size_t>(row) * EntityModel::kMaxLeds]; }

  /// Whether a ray of the bundle could hit anything; in doubt, yes. Its segments are not looked at. Far cheaper than
  /// casting. Thread-safe outside `move`.
  bool mayHit(const RayBundle& rays) const;
  /// Casts rays against everything: the terrain, all engines, and entities in no engine. For each segment the nearest
  /// hit.
  /// Thread-safe outside `move`.
  void raycast(const RayBundle& rays, Span<RayHit> hits) const;
  /// One ray, through up to two entities.
  RayHit castRay(const Segment& segment, Row ignored = kNoRow, Row also_ignored = kNoRow) const;
  /// Whether something other than the two stands between the points (thesis 3.4, "physical occlusions").
  bool isOccluded(const Segment& segment, Row from, Row to) const;

  /// Grows all columns to the entities' rows; after entities were added.
  void fitRows();

  /// Entities in no engine, by row: rays are cast against their models. Kept by add and remove of entities.
  std::vector<Row> entities_without_engine;
};

/// A hash of all named state, in the order of entity numbers (XXH3): clock, poses, twists, joints, LEDs, grips,
/// attachments, laser spots, and which engine moves whom.
/// Equal hashes each tick mean equal runs; -0 counts as 0.
std::uint64_t stateHash(const Space& space);

}  // namespace swarmanoid

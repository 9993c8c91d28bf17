/// The content of a snapshot: which entities there are, as values; the state of all objects, as bytes; and lists that
/// are mostly empty.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <typeindex>
#include <vector>

#include "../world/world.hpp"
#include "swarmanoid_space/snapshot/snapshot.hpp"

namespace swarmanoid {

struct Snapshot::Data {
  /// A membership of an entity, with the engine by its place in Space::engines.
  struct Place {
    std::size_t engine = 0;
    Role role = Role::kMove;
    bool is_listed = true;
  };
  struct Robot {
    std::string type;
    std::size_t group = 0;  ///< place in Assembly::groups
    CommandSource source = CommandSource::kController;
    Duration command_timeout{};
    bool has_controller = false;  ///< of its own
  };
  struct Entity {
    Row row = kNoRow;
    EntityNumber number = kNoEntity;
    std::string name;
    std::shared_ptr<const EntityModel> model;
    Pose pose;
    std::vector<Place> places;
    std::optional<Robot> robot;
  };
  struct Trigger {
    std::size_t rule = 0;  ///< place in Experiment::handovers
    Row row = kNoRow;
    EntityNumber number = kNoEntity;
    bool was_true = false;
    bool is_due = false;
    bool is_refused = false;
  };

  std::vector<std::string> parts;  ///< engines, controller groups with their devices, and rules of the experiment
  /// Classes of the controllers of groups that are stepped together, by group; void for other groups.
  std::vector<std::type_index> controllers;
  std::vector<Entity> entities;  ///< by entity number
  std::size_t row_count = 0;
  std::vector<Trigger> triggers;
  std::vector<std::byte> bytes;  ///< see archiveState

  std::uint64_t tick = 0;
  Time time = kEpoch;
  std::uint64_t seed = 0;
  bool rules_have_begun = false;
  bool is_finish_asked = false;
  bool is_finished = false;
  std::size_t player_position = 0;

  std::vector<std::shared_ptr<const Configuration>> engine_parameters;
  std::vector<LaserSpot> laser_spots;
  std::vector<Event> events;
  std::vector<Event> pending_events;
  std::vector<TakenIntervention> interventions;
  std::vector<TakenIntervention> pending_interventions;
  std::vector<Overflow> overflows;
  std::vector<ControllerFailure> failures;
  InterventionQueue queue;
};

/// Takes everything but the members that belong to Simulation. @throws std::runtime_error naming the part that has no
/// defined state, or the robot that is commanded from another process
std::unique_ptr<Snapshot::Data> takeSnapshot(World& world);

/// Gives a world the state of a snapshot. Robots keep their controllers if the world has the entities of the snapshot;
/// otherwise it is built anew with these. @throws ConfigError if the snapshot is of another experiment; then nothing
/// has changed
void restoreSnapshot(World& world, const Snapshot::Data& data);

/// Snapshot::Data::controllers of a world.
std::vector<std::type_index> controllersOf(const World& world);

/// Names of the parts that a world of an experiment has: engines, controllers with their devices, rules.
std::vector<std::string> partsOf(const World& world);

/// Saves or loads the state of all objects of a world. @pre when it loads, the world has the entities of the snapshot
void archiveState(World& world, StateArchive& state);

/// Makes a world have the entities of a snapshot, with its robots, controllers and triggers.
void restoreStructure(World& world, const Snapshot::Data& data);

}  // namespace swarmanoid

/// Interventions: changes of a world from outside its robots and its physics, as values. Callers (services, rules,
/// files) request a change with one of these types; Simulation::apply carries out all of them.
///
/// Phase    between ticks; an intervention is carried out completely or not at all.
/// Errors   a ConfigError with the reason of the refusal.
/// Records  interventions that changed something are listed in Space::interventions, in order; what happened is listed
///          in Space::events.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "swarmanoid_space/error_models/error_model_description.hpp"
#include "swarmanoid_space/experiment/experiment.hpp"
#include "swarmanoid_space/state/entities.hpp"
#include "swarmanoid_space/state/paint_layer.hpp"

namespace swarmanoid {

/// Names of parameters, and values as they would stand in the experiment file.
using NamedValues = std::vector<std::pair<std::string, std::string>>;

/// Adds an entity to the named engines; the first of them moves it. Refused: an invalid pose, an overlap, an unknown
/// name, a controller for another type of robot.
struct SpawnEntity {
  static constexpr const char* kKind = "spawn";
  EntityDescription entity;
  std::vector<std::string> engines;  ///< by id; empty: the entity is only visible
};

/// Removes an entity from the world. Refused: an unknown name.
struct DeleteEntity {
  static constexpr const char* kKind = "delete";
  std::string entity;
};

/// Moves an entity to another pose, at rest; all its grips and attachments, and those of others on it, are released.
/// Refused: an unknown name, an invalid pose, an overlap.
struct MoveEntity {
  static constexpr const char* kKind = "move";
  std::string entity;
  Pose pose;
};

/// Hands an entity over to another engine, with all entities connected to it: poses, twists, grips, devices, commands
/// and readings stay as they are. The old engine keeps a mirror of the entity if the experiment file (or the spawn)
/// lists the entity there. Nothing happens if the new engine moves the entity already. Refused: an unknown name; an
/// entity that is fixed, misplaced, in the way of something else, or not supported by the engine.
struct HandOverEntity {
  static constexpr const char* kKind = "handover";
  std::string entity;
  std::string engine;
};

/// Sets parameters of an engine. They act from the next tick on. A value equal to the current one changes nothing.
/// Refused: an unknown engine or parameter, one that is not live, an invalid value.
struct SetEngineParameters {
  static constexpr const char* kKind = "engine_parameters";
  std::string engine;
  NamedValues values;
};

/// Changes the command source of a robot, from now on. A controller in this process starts anew. A robot without a
/// command source stops; one that is commanded over topics stops until its first command. A robot that is commanded
/// from another process keeps its last commands until a participant answers. A robot with an empty battery changes its
/// source once the battery holds enough. Refused: an unknown robot, a controller that does not start, a device that
/// cannot be transmitted.
struct SetCommandSource {
  static constexpr const char* kKind = "command_source";
  std::string robot;
  CommandSource source = CommandSource::kController;
};

/// The property of entities whose own colour cameras see: lamps, preys.
constexpr const char* kColorProperty = "color";

/// Sets a property of an entity (EntityModel::properties); the value is written as in the experiment file. Nothing
/// happens if the property has this value. Refused: an unknown entity or property, an invalid value.
struct SetProperty {
  static constexpr const char* kKind = "property";
  std::string entity;
  std::string property;
  std::string value;
};

/// Paints discs on the floor, each over the previous ones and over the existing paint (PaintLayer). Refused: an arena
/// without <floor_paint>, a centre outside the arena, a radius or strength out of bounds, an empty list, and discs with
/// more than kMostCells cells in the squares around them. The simulation waits until all discs are painted.
struct PaintFloor {
  static constexpr const char* kKind = "paint";
  static constexpr Range kRadius{0.0, 10000.0};  ///< [m]
  static constexpr Range kStrength{0.001, 1.0};
  static constexpr std::size_t kMostCells = PaintLayer::kMostCells;  ///< one disc may cover the largest floor

  /// @throws ConfigError if the squares have more than kMostCells cells together
  static void requireFewCells(std::size_t cells);

  std::vector<PaintDisc> discs;
};

/// Replaces the faults of a sensor or an actuator of one robot from the next tick on. They act after the errors of its
/// configuration, for any command source of the robot. They last until the next fault of that device, until a reset, or
/// until the robot is removed. Omitted parameters have their defaults. Nothing happens if the device has the same
/// faults already. Refused: an entity that is not a robot with a controller, a device that it does not have, and
/// everything that the experiment file refuses of an <error>.
struct SetFault {
  static constexpr const char* kKind = "fault";
  std::string robot;
  std::string device;                         ///< its type, "footbot_proximity"
  std::vector<ErrorModelDescription> errors;  ///< in the order in which they act; empty: the device is repaired
};

using Intervention = std::variant<SpawnEntity, DeleteEntity, MoveEntity, HandOverEntity, SetEngineParameters,
                                  SetCommandSource, SetProperty, PaintFloor, SetFault>;

/// The name of its kind: "spawn", "delete", "move", "handover", "engine_parameters", "command_source", "property",
/// "paint", "fault".
inline const char* kindOf(const Intervention& intervention) {
  return std::visit([](const auto& what) { return what.kKind; }, intervention);
}

/// An intervention that has been carried out.
struct TakenIntervention {
  Intervention what;
  std::string asked_by;    ///< "rule 'foraging' (foraging)"; "": from outside, by the caller of the simulation
  std::uint64_t tick = 0;  ///< the next tick at that time; 0: before the first one
  /// Whether the rules' beforeTick of that tick had been called. The tick had then begun, waited for another process,
  /// and was given up for this intervention.
  bool after_rules = false;
};

/// An intervention of an earlier run, to be carried out again.
struct RecordedIntervention {
  TakenIntervention taken;
  SourceLocation location;  ///< in the file that it comes from
};

}  // namespace swarmanoid

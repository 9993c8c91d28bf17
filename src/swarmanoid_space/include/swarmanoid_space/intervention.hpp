/// What may be done to a world from outside its robots and its physics, as values: whoever asks (services, rules,
/// files) asks with one of these, and all are carried out by Simulation::apply.
///
/// Phase    between ticks; all that an intervention asks for is done, or nothing.
/// Errors   a ConfigError says why one is refused.
/// Records  those that changed something stand in Space::interventions, in their order, as what happened does in
///          Space::events.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "swarmanoid_space/error_models/error_model_description.hpp"
#include "swarmanoid_space/experiment_file/experiment.hpp"
#include "swarmanoid_space/state/entities.hpp"
#include "swarmanoid_space/state/paint_layer.hpp"

namespace swarmanoid {

/// Names of parameters, and values as they would stand in the experiment file.
using NamedValues = std::vector<std::pair<std::string, std::string>>;

/// Adds an entity to the engines named, of which the first moves it. Refused: a bad place, an overlap, an unknown name,
/// a controller for other robots.
struct SpawnEntity {
  EntityDescription entity;
  std::vector<std::string> engines;  ///< by id; none: it is there to be seen
};

/// Takes an entity out of the world. Refused: an unknown name.
struct DeleteEntity {
  std::string entity;
};

/// Puts an entity elsewhere, at rest; what held it lets go. Refused: an unknown name, a bad place, an overlap.
struct MoveEntity {
  std::string entity;
  Pose pose;
};

/// Another engine moves the entity from now on, and all that is connected to it: poses, twists, grips, devices,
/// commands and readings stay as they are. An engine that gives an entity up keeps a mirror of it if the experiment
/// file (or whoever spawned it) lists the entity there. Nothing happens if that engine moves it already. Refused: an
/// unknown name; one of them is fixed, misplaced, in the way of something else or beyond what the engine can simulate.
struct HandOverEntity {
  std::string entity;
  std::string engine;
};

/// Gives parameters of an engine new values. The engine works with them from the next tick on. What is given the value
/// that it has changes nothing. Refused: an unknown engine or parameter, one that is not live, a bad value.
struct SetEngineParameters {
  std::string engine;
  NamedValues values;
};

/// Another source commands the robot from now on. A controller in this process starts anew; a robot that nobody
/// commands stops, one that is commanded over topics until the first command comes; one whose commands come from
/// elsewhere keeps the last ones until a participant answers; one whose battery is empty is commanded so once it holds
/// enough. Refused: no such robot, a controller that does not start, a device that cannot travel.
struct SetCommandSource {
  std::string robot;
  CommandSource source = CommandSource::kController;
};

/// The property of whatever cameras see in a colour of its own: lamps, preys.
constexpr const char* kColorProperty = "color";

/// Gives a property of an entity (EntityModel::properties) another value, as it would stand in the experiment file.
/// Nothing happens if it has that value. Refused: an unknown entity or property, a bad value.
struct SetProperty {
  std::string entity;
  std::string property;
  std::string value;
};

/// Paints discs on the floor, each over those before it and over what was there (PaintLayer). Refused: an arena without
/// <floor_paint>, a middle outside the arena, a radius or strength out of bounds, no disc, and discs with more than
/// kMostCells cells in the squares around them. The rest of the world waits for all of them.
struct PaintFloor {
  static constexpr Range kRadius{0.0, 10000.0};  ///< [m]
  static constexpr Range kStrength{0.001, 1.0};
  static constexpr std::size_t kMostCells = PaintLayer::kMostCells;  ///< one disc may cover the largest floor

  /// @throws ConfigError if the squares have more than kMostCells cells together
  static void requireFewCells(std::size_t cells);

  std::vector<PaintDisc> discs;
};

/// What is wrong with a sensor or an actuator of one robot from the next tick on, beside and after the errors of its
/// configuration, whoever commands the robot; until the next fault of that device, which takes the place of this one,
/// until a reset, or as long as the robot is there. Parameters that are left out have their defaults. Nothing happens
/// if the same is wrong with it already. Refused: no robot with a controller, a device that it does not have, and what
/// the experiment file refuses of an <error>.
struct SetFault {
  std::string robot;
  std::string device;                         ///< its type, "footbot_proximity"
  std::vector<ErrorModelDescription> errors;  ///< in the order in which they act; none: the device is mended
};

using Intervention = std::variant<SpawnEntity, DeleteEntity, MoveEntity, HandOverEntity, SetEngineParameters,
                                  SetCommandSource, SetProperty, PaintFloor, SetFault>;

/// An intervention that has been carried out.
struct TakenIntervention {
  Intervention what;
  std::string asked_by;    ///< "rule 'foraging' (foraging)"; "": from outside, by whoever runs the simulation
  std::uint64_t tick = 0;  ///< the tick that was to come: 0, before the first one
  /// Whether the rules' beforeTick of that tick had been called: the tick had begun, waited for another process, and
  /// was given up for this intervention.
  bool after_rules = false;
};

}  // namespace swarmanoid

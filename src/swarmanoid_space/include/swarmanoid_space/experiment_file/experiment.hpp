/// An experiment as its file describes it (thesis 4.2), checked but not yet built.
///
/// Plain data: what reads files produces it, what builds simulations consumes it, tests write it by hand. Angles are in
/// radians here, degrees only in the file. Every part has the place that it came from, for messages.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "swarmanoid_interface/color.hpp"
#include "swarmanoid_interface/configuration.hpp"
#include "swarmanoid_interface/time.hpp"
#include "swarmanoid_space/error_models/error_model_description.hpp"
#include "swarmanoid_space/index/positional_index.hpp"
#include "swarmanoid_space/rays/terrain.hpp"
#include "swarmanoid_space/state/entities.hpp"
#include "swarmanoid_space/state/floor.hpp"

namespace swarmanoid {

struct FrameworkDescription {
  Duration clocktick = std::chrono::milliseconds(100);
  std::uint64_t max_clock = 0;               ///< ticks after which the run is finished
  std::vector<std::string> controller_path;  ///< folders that libraries are looked for in first
  std::uint64_t seed = 1;
  int threads = 1;
  double real_time_factor = 0.0;  ///< 0: as fast as possible
  SourceLocation location;        ///< of max_clock
};

/// One device in a controller's `<actuators>` or `<sensors>`.
struct DeviceDescription {
  std::string type;                           ///< never an alias
  std::string implementation;                 ///< never an alias, never empty
  std::string library;                        ///< "" if it is already known
  Configuration parameters;                   ///< defaults filled in
  std::vector<ErrorModelDescription> errors;  ///< in the order of the file
  SourceLocation location;
};

struct ControllerDescription {
  std::string label;  ///< the tag
  std::string id;
  std::string library;
  std::string script;  ///< the file in Python that has it, under its label; "": it is in C++
  std::vector<DeviceDescription> actuators;
  std::vector<DeviceDescription> sensors;
  Configuration parameters;  ///< `<parameters>`; the controller itself checks it
  SourceLocation location;
};

/// Where many entities go.
struct Distribution {
  enum class Layout {
    kUniform,  ///< at random places
    kGrid      ///< at even distances
  };
  /// Where the origins are. Discs and rings lie level.
  enum class Area {
    kBox,   ///< `minimum` to `maximum`
    kDisc,  ///< `radius` around `center`
    kRing,  ///< `inner_radius` to `radius` around `center`
    kLine   ///< `from` to `to`
  };

  Layout layout = Layout::kUniform;
  Area area = Area::kBox;
  std::size_t quantity = 0;
  Eigen::Vector3d minimum = Eigen::Vector3d::Zero();  ///< [m]
  Eigen::Vector3d maximum = Eigen::Vector3d::Zero();  ///< [m]
  Eigen::Vector3d center = Eigen::Vector3d::Zero();   ///< [m]
  double radius = 0.0;                                ///< [m]
  double inner_radius = 0.0;                          ///< at most `radius` [m]
  Eigen::Vector3d from = Eigen::Vector3d::Zero();     ///< [m]
  Eigen::Vector3d to = Eigen::Vector3d::Zero();       ///< [m]
  /// The entity from whose origin all x and y count; it is placed before these. "": from that of W.
  std::string around;
  bool random_heading = true;  ///< uniform about z; otherwise the prototype's orientation
  int max_trials = 100;        ///< for each entity, before it is an error
  SourceLocation location;

  /// The smallest box that holds the area.
  Eigen::AlignedBox3d bounds() const;
  /// A point of the area, uniform if the shares are. @param shares from 0 to 1; of a box along x, y and z
  Eigen::Vector3d pointAt(const Eigen::Vector3d& shares) const;
};

/// Who commands a robot.
enum class CommandSource {
  kController,  ///< its controller, in the simulator's process
  kRemote,      ///< its controller, in another process that has registered for it
  kTopics,      ///< publishers on the topics of its actuators
  kNone         ///< no source
};

/// Whether another process than the simulator's commands the robot.
inline bool isOfOthers(CommandSource source) {
  return source == CommandSource::kRemote || source == CommandSource::kTopics;
}
/// "controller", "remote", "topics", "none".
const char* toString(CommandSource source);
/// @return nothing if it is none
std::optional<CommandSource> parseCommandSource(const std::string& text);

/// As long as drivers of robots wait.
constexpr Duration kCommandTimeout = std::chrono::milliseconds(500);

struct EntityDescription {
  std::string type;
  std::string id;  ///< with a distribution, the entities are id_1, id_2, ...
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Vector3d angles = Eigen::Vector3d::Zero();  ///< Euler angles [rad]
  std::string controller;                            ///< id of a controller; "" for none
  SourceLocation controller_location;
  CommandSource source = CommandSource::kController;
  Duration command_timeout = kCommandTimeout;  ///< with kTopics: it stops when no command came for so long
  Color color;                                 ///< of the surface (preys, lights); black: not seen by cameras
  Configuration parameters;                    ///< the type's own values, defaults filled in
  std::optional<Distribution> distribution;
  SourceLocation location;
};

struct ArenaDescription {
  Eigen::Vector3d corner = Eigen::Vector3d::Zero();  ///< of the arena, with its least coordinates [m]
  Eigen::Vector3d size = Eigen::Vector3d::Ones();    ///< of the arena from there [m]
  Eigen::Vector3d farCorner() const { return corner + size; }
  PositionalIndex::Optimization optimization = PositionalIndex::Optimization::k2D;
  bool bounded = false;  ///< walls along the four sides, in every engine
  std::vector<EntityDescription> entities;
  Floor floor;                             ///< without paint
  std::optional<PaintDescription> paint;   ///< `<floor_paint>`; nothing: the floor takes none
  std::shared_ptr<const Terrain> terrain;  ///< `<heightfield>`; null: the floor is level
  SourceLocation location;
};

/// A plugin with an id, as a section lists it.
struct PluginUse {
  std::string label;  ///< never an alias
  std::string id;
  std::string library;
  std::string script;        ///< of a rule: the file in Python that has it, under its label; "": it is in C++
  Configuration parameters;  ///< defaults filled in; of what is in Python, whatever stands there
  SourceLocation location;
};
using EngineDescription = PluginUse;
using RuleDescription = PluginUse;
using VisualisationDescription = PluginUse;

enum class Role {
  kMove,   ///< the engine moves the entity
  kMirror  ///< the engine holds it where another engine moves it
};

/// One `<engine>` of `<arena_physics>`.
struct MappingDescription {
  struct Member {
    std::string entity;  ///< an entity's id, or that of a distributed group
    std::optional<Role> role;
    SourceLocation location;
  };

  std::string engine;
  std::vector<Member> members;
  SourceLocation location;
};

/// One `<handover>` of `<arena_physics>`: when its condition becomes true, an engine takes the entity over.
struct HandoverDescription {
  enum class Condition {
    kInside,    ///< the entity's origin is in the box
    kOutside,   ///< it is not
    kAttached,  ///< the entity grips something, or is gripped
    kReleased,  ///< it does not
    kDebug      ///< the controller's debug value `key` is `value`
  };
  /// Which end of a grip counts.
  enum class End { kAny, kGripper, kGripped };

  std::string id;      ///< "" for none
  std::string entity;  ///< an entity's id, or that of a distributed group: then for each of them
  std::string engine;  ///< that takes it over
  Condition condition = Condition::kInside;
  Eigen::Vector3d minimum = Eigen::Vector3d::Zero();  ///< of the box, in W, borders included [m]
  Eigen::Vector3d maximum = Eigen::Vector3d::Zero();
  End end = End::kAny;
  std::string key;
  std::string value;
  SourceLocation location;
};

/// One `path=value` that replaces what the file says, such as "framework.maxclock=200" or
/// "controllers.fc.parameters.wheels_speed=8" (elements by tag or, where they have one, by id).
struct Override {
  std::string path;
  std::string value;
};

struct Experiment {
  std::string name;  ///< the file's name without folder and ending
  std::string file;
  std::string text;                 ///< the file as it was read, for recordings
  std::vector<Override> overrides;  ///< that were applied to it
  std::vector<std::string> files;   ///< that it was read from: its own, images
  FrameworkDescription framework;
  std::vector<ControllerDescription> controllers;
  ArenaDescription arena;
  std::vector<EngineDescription> engines;
  std::vector<MappingDescription> mappings;
  std::vector<HandoverDescription> handovers;
  std::vector<RuleDescription> rules;
  std::vector<VisualisationDescription> visualisations;
};

/// Reads and checks an experiment file, and loads the libraries it names.
/// @throws ConfigError for the first mistake: file, line, what was found, what is allowed, the nearest right name
Experiment readExperiment(const std::string& file, const std::vector<Override>& overrides = {});

/// The same from a text; `name` stands for the file in messages.
Experiment parseExperiment(const std::string& text, const std::string& name,
                           const std::vector<Override>& overrides = {});

/// Loads the suite's own plugins (engines, devices, visualisations), once.
/// @throws ConfigError if one is not installed
void loadBuiltInPlugins();

/// What readExperiment warned of since the last call, such as a controller_path that does not exist.
std::vector<std::string> takeExperimentWarnings();

/// Robots with a controller, in the order of the file. What a distribution makes is spelled out.
/// @param source only those that are commanded so
std::vector<std::string> robotNames(const Experiment& experiment, std::optional<CommandSource> source = {});

/// The robots that a parameter means: names, "all" alone, "none" alone.
/// @throws ConfigError for one that is none
std::vector<std::string> chooseRobots(const std::vector<std::string>& words, const std::string& parameter,
                                      const Experiment& experiment);

}  // namespace swarmanoid

/// An experiment as its file describes it (thesis 4.2), checked but not yet built.
///
/// Plain data: the reader of files produces it, the builder of simulations consumes it, tests write it by hand. Angles
/// are in radians here, degrees only in the file. Every part keeps its location in the file, for messages.
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
  std::vector<std::string> controller_path;  ///< folders searched first for libraries
  std::uint64_t seed = 1;
  int threads = 1;
  double real_time_factor = 0.0;  ///< 0: as fast as possible
  SourceLocation location;        ///< of max_clock
};

/// One device in a controller's `<actuators>` or `<sensors>`.
struct DeviceDescription {
  std::string type;                           ///< never an alias
  std::string implementation;                 ///< never an alias, never empty
  std::string library;                        ///< "" if it is already loaded
  Configuration parameters;                   ///< defaults filled in
  std::vector<ErrorModelDescription> errors;  ///< in the order of the file
  SourceLocation location;
};

struct ControllerDescription {
  std::string label;  ///< the tag
  std::string id;
  std::string library;
  std::string script;  ///< Python file that contains the controller, under its label; "": in C++
  std::vector<DeviceDescription> actuators;
  std::vector<DeviceDescription> sensors;
  Configuration parameters;  ///< `<parameters>`; checked by the controller itself
  SourceLocation location;
};

/// The placement of many entities.
struct Distribution {
  enum class Layout {
    kUniform,  ///< random positions
    kGrid      ///< regular positions
  };
  /// Region of the origins. Discs and rings are horizontal.
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
  /// The entity whose origin is the origin of all x and y; it is placed before these. "": the origin of W.
  std::string around;
  bool random_heading = true;  ///< uniform about z; otherwise the prototype's orientation
  int max_trials = 100;        ///< for each entity; then it is an error
  SourceLocation location;

  /// The smallest box that contains the area.
  Eigen::AlignedBox3d bounds() const;
  /// A point of the area; uniformly distributed if the shares are.
  /// @param shares from 0 to 1; for a box along x, y and z
  Eigen::Vector3d pointAt(const Eigen::Vector3d& shares) const;
};

/// The command source of a robot.
enum class CommandSource {
  kController,  ///< its controller, in the simulator's process
  kRemote,      ///< its controller, in another process that has registered for it
  kTopics,      ///< publishers on the topics of its actuators
  kNone         ///< no command source
};

/// Whether a process other than the simulator's commands the robot.
inline bool isOfOthers(CommandSource source) {
  return source == CommandSource::kRemote || source == CommandSource::kTopics;
}
/// "controller", "remote", "topics", "none".
const char* toString(CommandSource source);
/// @return nothing if the text is none of these
std::optional<CommandSource> parseCommandSource(const std::string& text);

/// The same time-out as that of the robots' drivers.
constexpr Duration kCommandTimeout = std::chrono::milliseconds(500);

struct EntityDescription {
  std::string type;
  std::string id;  ///< with a distribution, the entities are id_1, id_2, ...
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Vector3d angles = Eigen::Vector3d::Zero();  ///< Euler angles [rad]
  std::string controller;                            ///< id of a controller; "" for none
  SourceLocation controller_location;
  CommandSource source = CommandSource::kController;
  Duration command_timeout = kCommandTimeout;  ///< with kTopics: the robot stops after this time without a command
  Color color;                                 ///< of the surface (preys, lights); black: not seen by cameras
  Configuration parameters;                    ///< of the type, including defaults
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
  std::optional<PaintDescription> paint;   ///< `<floor_paint>`; nothing: the floor cannot be painted
  std::shared_ptr<const Terrain> terrain;  ///< `<heightfield>`; null: the floor is level
  SourceLocation location;
};

/// A plugin with an id, as listed in a section.
struct PluginUse {
  std::string label;  ///< never an alias
  std::string id;
  std::string library;
  std::string script;        ///< of a rule: Python file that contains it, under its label; "": in C++
  Configuration parameters;  ///< including defaults; unchecked if the plugin is in Python
  SourceLocation location;
};
using EngineDescription = PluginUse;
using RuleDescription = PluginUse;
using VisualisationDescription = PluginUse;

enum class Role {
  kMove,   ///< the engine moves the entity
  kMirror  ///< the engine keeps it at the pose that another engine gives it
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

/// One `<handover>` of `<arena_physics>`: an engine takes the entity over when the condition becomes true.
struct HandoverDescription {
  enum class Condition {
    kInside,    ///< the entity's origin is in the box
    kOutside,   ///< the entity's origin is outside the box
    kAttached,  ///< the entity grips something, or is gripped
    kReleased,  ///< the entity neither grips nor is gripped
    kDebug      ///< the controller's debug value `key` is `value`
  };
  /// The end of a grip that counts.
  enum class End { kAny, kGripper, kGripped };

  std::string id;      ///< "" for none
  std::string entity;  ///< id of an entity or of a distributed group; a group stands for each of its entities
  std::string engine;  ///< the new engine
  Condition condition = Condition::kInside;
  Eigen::Vector3d minimum = Eigen::Vector3d::Zero();  ///< of the box, in W, borders included [m]
  Eigen::Vector3d maximum = Eigen::Vector3d::Zero();
  End end = End::kAny;
  std::string key;
  std::string value;
  SourceLocation location;
};

/// One `path=value` that replaces a value of the file, such as "framework.maxclock=200" or
/// "controllers.fc.parameters.wheels_speed=8" (elements by tag, or by id if they have one).
struct Override {
  std::string path;
  std::string value;
};

struct Experiment {
  std::string name;  ///< the file's name without folder and ending
  std::string file;
  std::string text;                 ///< the file as it was read, for recordings
  std::vector<Override> overrides;  ///< applied to it
  std::vector<std::string> files;   ///< files that were read: the experiment file, images
  FrameworkDescription framework;
  std::vector<ControllerDescription> controllers;
  ArenaDescription arena;
  std::vector<EngineDescription> engines;
  std::vector<MappingDescription> mappings;
  std::vector<HandoverDescription> handovers;
  std::vector<RuleDescription> rules;
  std::vector<VisualisationDescription> visualisations;
};

/// Robots with a controller, in the order of the file. Distributions are expanded.
/// @param source if given, only robots with this command source
std::vector<std::string> robotNames(const Experiment& experiment, std::optional<CommandSource> source = {});

/// The robots that a parameter selects: names, "all" alone, "none" alone.
/// @throws ConfigError for an unknown robot
std::vector<std::string> chooseRobots(const std::vector<std::string>& words, const std::string& parameter,
                                      const Experiment& experiment);

}  // namespace swarmanoid

/// The registry of all plugins that an experiment file can name: controllers, sensors, actuators, engines,
/// visualisations, rules and entity types. A plugin is registered when its library is loaded; libraries are never
/// unloaded.
///
/// Keys are strings, never C++ types, so plugins that were built separately can be registered side by side.
/// Registration happens while a library loads (one thread); afterwards the registry is only read.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "swarmanoid_interface/configuration.hpp"
#include "swarmanoid_interface/mechanism.hpp"

namespace swarmanoid {

enum class PluginKind { kController, kSensor, kActuator, kEngine, kObserver, kEntity, kRule };

/// All of them, in the order in which they are listed.
inline constexpr std::array<PluginKind, 7> kPluginKinds{
    PluginKind::kController, PluginKind::kSensor,   PluginKind::kActuator, PluginKind::kEngine,
    PluginKind::kRule,       PluginKind::kObserver, PluginKind::kEntity};

/// Returns "controller", "sensor", ...
const char* toString(PluginKind kind);

/// One value that a plugin reads from the experiment file. The parser, the XSD, `swarmanoid list` and the reference
/// pages are all generated from these descriptions, so they cannot differ.
struct Parameter {
  enum class Type {
    kNumber,
    kInteger,
    kBoolean,  ///< true, false
    kText,
    kChoice,   ///< one of `choices`
    kVector2,  ///< "x, y"
    kVector3,  ///< "x, y, z"
    kAngle,    ///< degrees
    kAngles3,  ///< "alpha, beta, gamma" in degrees
    kColor     ///< a colour name or "r,g,b"
  };

  std::string name;
  Type type = Type::kText;
  std::string description;           ///< one sentence
  std::string unit;                  ///< of numbers: "m", "rad/s", "" for none
  std::optional<std::string> value;  ///< the default, as written in the file; without one the parameter must be given
  Range range;                       ///< range of the number, or of each number of several
  std::vector<std::string> choices;
  bool is_live = false;  ///< for engines: the value may change while an experiment runs
};

/// Checks one value against its parameter. @throws ConfigError
void checkValue(const Parameter& parameter, const std::string& text, const SourceLocation& location);

/// A short way to write a parameter in a table. @param value the default; without one the parameter must be given
inline Parameter makeParameter(std::string name, Parameter::Type type, std::string unit,
                               std::optional<std::string> value, Range range, std::string description) {
  Parameter parameter;
  parameter.name = std::move(name);
  parameter.type = type;
  parameter.description = std::move(description);
  parameter.unit = std::move(unit);
  parameter.value = std::move(value);
  parameter.range = range;
  return parameter;
}

/// The description that a plugin gives of itself.
struct PluginDescription {
  std::string label;           ///< the tag in the experiment file: a controller's, an engine's, ... or a device's type
  std::string implementation;  ///< sensors and actuators: the value of `<implementation>`; "" for the other kinds
  bool is_default = false;     ///< sensors and actuators: used where no implementation is named
  std::string summary;         ///< one sentence
  std::vector<Parameter> parameters;
  std::vector<std::string> label_aliases;           ///< other tags that mean the same (the names of the thesis)
  std::vector<std::string> implementation_aliases;  ///< other values of `<implementation>` that mean the same
  std::vector<Mechanism> mechanisms;                ///< sensors and actuators: mechanisms that the robot must have
  /// Devices: robot types that have the device even if their description does not list it; empty: any. It is kRobot of
  /// the device's struct, if defined.
  std::vector<std::string> robots;
  bool free_parameters = false;  ///< the plugin reads parameters of any name (controllers)
};

class Registry {
 public:
  /// Makes a plugin; the pointer is to the kind's base class (Controller, Sensor, ...).
  using Factory = std::function<std::shared_ptr<void>()>;

  struct Entry {
    PluginKind kind;
    PluginDescription description;
    Factory make;
  };

  /// A plugin that was refused because its name is taken, or that is not the default because another one is.
  struct Conflict {
    PluginKind kind;
    std::string label;
    std::string implementation;
    std::string first_library;   ///< file name of the one that is used
    std::string second_library;  ///< file name of the one that is not; it may be the same
    bool is_about_default = false;
  };

  static Registry& instance();

  /// The second plugin of the same kind, label and implementation is refused: the first stays, and the conflict is kept
  /// for `conflicts`. If two implementations claim to be the default, the first is the default.
  void add(PluginKind kind, PluginDescription description, Factory make);

  /// Finds an entry by label or alias. For devices an empty implementation means the default: the one declared as such,
  /// or the only one. If there are several and none is declared, it is the first by name; see `hasDefault`.
  /// @return null if there is none
  const Entry* find(PluginKind kind, const std::string& label, const std::string& implementation = "") const;

  /// Returns whether a registered device of that label has an implementation that is used where none is named.
  bool hasDefault(PluginKind kind, const std::string& label) const;

  /// Returns an entry by label or alias.
  /// @throws std::runtime_error naming all labels of the kind, if there is none
  const Entry& require(PluginKind kind, const std::string& label) const;

  /// Returns all entries of a kind, sorted by label and implementation.
  std::vector<const Entry*> all(PluginKind kind) const;

  /// Returns all labels of a kind, sorted, each once, without aliases.
  std::vector<std::string> labels(PluginKind kind) const;

  /// Returns the conflicts in the order in which they occurred.
  const std::vector<Conflict>& conflicts() const { return conflicts_; }

 private:
  std::vector<std::unique_ptr<Entry>> entries_;
  std::vector<Conflict> conflicts_;
};

/// "sensor 'footbot_proximity polynomial' is registered twice (liba.so, libb.so); the first is used"
std::string describe(const Registry::Conflict& conflict);

/// Registers class `Plugin` (of base `Base`) while its library loads; it is used through the REGISTER_ macros.
template <class Base, class Plugin>
struct PluginRegistration {
  PluginRegistration(PluginKind kind, const PluginDescription& description) {
    Registry::instance().add(kind, description, [] {
      return std::static_pointer_cast<void>(std::static_pointer_cast<Base>(std::make_shared<Plugin>()));
    });
  }
};

/// Makes a plugin of a registry entry. `Base` must be the base class of the entry's kind.
template <class Base>
std::shared_ptr<Base> makePlugin(const Registry::Entry& entry) {
  return std::static_pointer_cast<Base>(entry.make());
}

}  // namespace swarmanoid

/// Composes the names of generated variables.
#define SWARMANOID_CONCATENATE_(a, b) a##b
#define SWARMANOID_CONCATENATE(a, b) SWARMANOID_CONCATENATE_(a, b)

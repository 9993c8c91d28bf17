/// Forbidden actions of users' code, by name.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "swarmanoid_interface/configuration.hpp"
#include "swarmanoid_interface/registry.hpp"

namespace swarmanoid {
class Space;
}

namespace swarmanoid::test {

/// Performs the action. Some actions return, some throw, some end the process, some never end.
/// @throws std::runtime_error starting with "no such action" and listing all names, if the name is unknown
void perform(const std::string& action);

/// Makes a space available to the action "spoil_state".
void expose(const Space& space);

/// All names of actions, sorted.
std::vector<std::string> actions();

/// The misbehaviour of a plugin other than a controller, from its parameters: `phase`, a function of the plugin, and
/// `action`.
class Misbehaviour {
 public:
  static constexpr std::uint64_t kTick = 3;

  /// Description of a plugin with this label that only misbehaves.
  static PluginDescription describe(const std::string& label);
  /// Performs the action at once if the phase is `configure`.
  void configure(const Configuration& parameters);
  void tryIn(const std::string& phase) const;
  /// Performs the action only in the tick kTick.
  void tryIn(const std::string& phase, std::uint64_t tick) const;

 private:
  std::string phase_;
  std::string action_;
};

}  // namespace swarmanoid::test

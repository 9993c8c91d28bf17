/// What users' code must not do, by name.
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

/// Does it. Some actions return, some throw, some end the process, some never end.
/// @throws std::runtime_error beginning with "no such action" and naming all, if there is none of that name
void perform(const std::string& action);

/// What the action "spoil_state" spoils, from now on.
void expose(Space& space);

/// All names, sorted.
std::vector<std::string> actions();

/// What a plugin that is no controller has been told to do by its parameters: `phase`, a function of it, and `action`.
class Misbehaviour {
 public:
  static constexpr std::uint64_t kTick = 3;

  /// Of a plugin with this label that has nothing but a misbehaviour.
  static PluginDescription describe(const std::string& label);
  /// Does it at once if the phase is `configure`.
  void configure(const Configuration& parameters);
  void tryIn(const std::string& phase) const;
  /// Only in that tick.
  void tryIn(const std::string& phase, std::uint64_t tick) const;

 private:
  std::string phase_;
  std::string action_;
};

}  // namespace swarmanoid::test

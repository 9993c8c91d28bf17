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

/// Does it. Some deeds return, some throw, some end the process, some never end.
/// @throws std::runtime_error beginning with "no such deed" and naming all, if there is none of that name
void commit(const std::string& deed);

/// What the deed "spoil_state" spoils, from now on.
void expose(Space& space);

/// All names, sorted.
std::vector<std::string> deeds();

/// What a plugin that is no controller has been told to do by its parameters: `phase`, a function of it, and `deed`.
class Misdeed {
 public:
  static constexpr std::uint64_t kTick = 3;

  /// Of a plugin with this label that has nothing but a misdeed.
  static PluginDescription describe(const std::string& label);
  /// Commits it at once if the phase is `configure`.
  void configure(const Configuration& parameters);
  void tryIn(const std::string& phase) const;
  /// Only in that tick.
  void tryIn(const std::string& phase, std::uint64_t tick) const;

 private:
  std::string phase_;
  std::string deed_;
};

}  // namespace swarmanoid::test

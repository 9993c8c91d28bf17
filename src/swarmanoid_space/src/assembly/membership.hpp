/// Memberships of an entity in engines, from the checked claims of a mapping or a spawn request.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "named_plugin.hpp"
#include "swarmanoid_space/engine.hpp"

namespace swarmanoid {

/// The membership of an entity in one engine, and its role there.
struct Membership {
  Engine* engine = nullptr;
  Role role = Role::kMove;
  bool is_listed = true;  ///< in the file or the spawn request; otherwise it lasts while the engine moves the entity
};

/// Memberships contain pointers to engines.
template <>
struct IsKeptApart<std::vector<Membership>> : std::true_type {};

/// A request to add an entity to an engine.
struct Claim {
  std::string engine;
  std::optional<Role> role;  ///< none: if no claim says kMove, the first engine moves it, others mirror it
  SourceLocation location;
};

/// Returns the memberships of an entity.
/// @throws ConfigError for an engine that does not exist or is claimed twice, and for two engines that would move the
/// entity
std::vector<Membership> membershipsOf(const std::string& entity, const std::vector<Claim>& claims,
                                      const std::vector<Named<Engine>>& engines);

}  // namespace swarmanoid

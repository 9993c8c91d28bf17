/// Which engines hold an entity: as a mapping or a spawn request claims it, checked.
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
  bool is_listed = true;  ///< by the experiment file or the spawn request; else it is there for as long as it is moved
};

/// A request that an engine hold an entity.
struct Claim {
  std::string engine;
  std::optional<Role> role;  ///< none: the first moves it, if no other claim says that it does
  SourceLocation location;
};

/// The memberships of an entity.
/// @throws ConfigError for an engine that does not exist or stands there twice, and for two that would move the entity
std::vector<Membership> membershipsOf(const std::string& entity, const std::vector<Claim>& claims,
                                      const std::vector<Named<Engine>>& engines);

}  // namespace swarmanoid

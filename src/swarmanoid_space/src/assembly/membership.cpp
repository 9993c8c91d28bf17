#include "membership.hpp"

#include <algorithm>

namespace swarmanoid {

std::vector<Membership> membershipsOf(const std::string& entity, const std::vector<Claim>& claims,
                                      const std::vector<Named<Engine>>& engines) {
  std::vector<Membership> memberships;
  bool is_moved = false;
  const bool has_mover =
      std::any_of(claims.begin(), claims.end(), [](const Claim& claim) { return claim.role == Role::kMove; });
  for (const Claim& claim : claims) {
    const auto found =
        std::find_if(engines.begin(), engines.end(), [&](const auto& engine) { return engine->id() == claim.engine; });
    if (found == engines.end()) {
      std::vector<std::string> known;
      for (const auto& engine : engines) {
        known.push_back(engine->id());
      }
      throw ConfigError(claim.location, unknownName("the engine", claim.engine, known));
    }
    if (std::any_of(memberships.begin(), memberships.end(),
                    [&](const Membership& membership) { return membership.engine == found->get(); })) {
      throw ConfigError(claim.location,
                        "found the entity '" + entity + "' twice in the engine '" + claim.engine + "', allowed: once");
    }
    // without a stated mover the first engine that lists the entity moves it
    const Role role = claim.role.value_or(has_mover || is_moved ? Role::kMirror : Role::kMove);
    if (role == Role::kMove && is_moved) {
      throw ConfigError(claim.location,
                        "found a second role=\"move\" for the entity '" + entity + "', allowed: one engine moves it");
    }
    is_moved = is_moved || role == Role::kMove;
    memberships.push_back({found->get(), role});
  }
  return memberships;
}

}  // namespace swarmanoid

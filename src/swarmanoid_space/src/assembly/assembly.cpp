#include "assembly.hpp"

#include <algorithm>

namespace swarmanoid {

Engine* Assembly::findEngine(const std::string& id) const {
  for (const auto& engine : engines) {
    if (engine->id() == id) {
      return engine.get();
    }
  }
  return nullptr;
}

ControllerGroup* Assembly::findGroup(const std::string& id) const {
  for (const auto& group : groups) {
    if (group->description->id == id) {
      return group.get();
    }
  }
  return nullptr;
}

RobotInstance* Assembly::findRobot(const Entities& entities, Row row) {
  if (row == kNoRow) {
    return nullptr;
  }
  const auto numberOf = [&](Row of) { return entities.number[of]; };
  const auto found = std::lower_bound(
      robots.begin(), robots.end(), numberOf(row),
      [&](const RobotInstance& instance, EntityNumber number) { return numberOf(instance.row) < number; });
  return found != robots.end() && found->row == row ? &*found : nullptr;
}

}  // namespace swarmanoid

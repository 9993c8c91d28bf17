#include "scripts.hpp"

#include "swarmanoid_interface/process/user_code.hpp"

namespace swarmanoid {
namespace {

ScriptHost& hostOf(World& world, const SourceLocation& location) {
  if (world.supplied.scripts == nullptr) {
    world.supplied.scripts = makeScriptHost(location);
  }
  return *world.supplied.scripts;
}

}  // namespace

std::shared_ptr<GroupController> controllerInScript(World& world, const ControllerDescription& description) {
  const std::string part = "controller '" + description.id + "'";
  return callUserCode(UserCode{"loading", part, ""},
                      [&] { return hostOf(world, description.location).makeController(description); });
}

std::shared_ptr<Rule> ruleInScript(World& world, const RuleDescription& description) {
  const std::string part = "rule '" + description.id + "'";
  return callUserCode(UserCode{"loading", part, "", UserCode::kNoTick, false},
                      [&] { return hostOf(world, description.location).makeRule(description); });
}

void forgetScripts(World& world) {
  if (world.supplied.scripts != nullptr) {
    world.supplied.scripts->forget();
  }
}

}  // namespace swarmanoid

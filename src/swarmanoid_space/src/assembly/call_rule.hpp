/// How rules are called.
#pragma once

#include <cstdint>
#include <stdexcept>

#include "named_plugin.hpp"
#include "swarmanoid_interface/process/user_code.hpp"

namespace swarmanoid {

/// Calls a hook of a rule. @param hook, tick as UserCode has them
/// @throws ConfigError if the rule does, std::runtime_error for anything else; both name the rule, "rule 'dock'
/// (recharge): no power", but for a ConfigError that has a place in a file
template <class Action>
void callRule(const char* hook, const RuleInstance& rule, std::uint64_t tick, Action action) {
  const UserCode code{hook, rule.part, "", tick, false};
  const UserCall call(code);
  try {
    action();
  } catch (const ConfigError& error) {
    if (!error.location().file.empty()) {
      throw;
    }
    throw ConfigError({}, rule.part + ": " + error.what());
  } catch (const std::exception&) {
    throw std::runtime_error(rule.part + ": " + describeException());
  } catch (...) {
    throw std::runtime_error(rule.part + " " + describeException());
  }
}

}  // namespace swarmanoid

/// Calls hooks of rules and adds the rule's name to their errors.
#pragma once

#include <cstdint>
#include <stdexcept>

#include "named_plugin.hpp"
#include "swarmanoid_interface/process/user_code.hpp"

namespace swarmanoid {

/// Calls a hook of a rule. @param hook, tick see UserCode
/// @throws ConfigError if the rule throws one, std::runtime_error for any other exception. Both name the rule, "rule
/// 'dock' (recharge): no power"; a ConfigError with a location in a file is passed on unchanged
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

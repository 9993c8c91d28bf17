/// How rules are called.
#pragma once

#include <cstdint>
#include <stdexcept>

#include "named_plugin.hpp"
#include "swarmanoid_interface/process/user_code.hpp"

namespace swarmanoid {

/// Calls a hook of a rule. @param hook, tick as UserCode has them
/// @throws ConfigError if the rule does; std::runtime_error that names the rule, "rule 'dock' (recharge): no power",
/// for anything else
template <class Action>
void callRule(const char* hook, const RuleInstance& rule, std::uint64_t tick, Action action) {
  const UserCode code{hook, rule.part, "", tick, false};
  const UserCall call(code);
  try {
    action();
  } catch (const ConfigError&) {
    throw;
  } catch (const std::exception&) {
    throw std::runtime_error(rule.part + ": " + describeException());
  } catch (...) {
    throw std::runtime_error(rule.part + " " + describeException());
  }
}

}  // namespace swarmanoid

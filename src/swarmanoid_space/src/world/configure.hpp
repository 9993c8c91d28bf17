/// Configures a plugin, with any exception converted to a ConfigError.
#pragma once

#include "../assembly/named_plugin.hpp"
#include "swarmanoid_interface/process/user_code.hpp"
#include "swarmanoid_space/experiment/experiment.hpp"

namespace swarmanoid {

/// @throws ConfigError for any exception of the plugin
template <class Plugin, class... Arguments>
void configure(const Named<Plugin>& plugin, const SourceLocation& location, const Arguments&... arguments) {
  const UserCode code{"configure", plugin.part, "", UserCode::kNoTick, false};
  const UserCall call(code);
  try {
    plugin->configure(arguments...);
  } catch (const ConfigError&) {
    throw;
  } catch (...) {
    throw ConfigError(location, plugin.part + " cannot be configured: " + describeException());
  }
}

}  // namespace swarmanoid

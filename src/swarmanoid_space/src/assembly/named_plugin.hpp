/// Plugins of a simulation, with their descriptions for messages.
#pragma once

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "swarmanoid_interface/expects.hpp"
#include "swarmanoid_space/observer.hpp"
#include "swarmanoid_space/rule.hpp"

namespace swarmanoid {

/// A plugin and its description for messages (UserCode::part): "engine 'ground' (dynamics2d)".
template <class Plugin>
struct Named {
  std::shared_ptr<Plugin> plugin;
  std::string part;

  Plugin* get() const { return plugin.get(); }
  Plugin* operator->() const { return plugin.get(); }
  Plugin& operator*() const { return *plugin; }
};

/// Returns the description of a plugin. @pre `plugins` contains it
template <class Plugin>
const std::string& partOf(const std::vector<Named<Plugin>>& plugins, const Plugin& plugin) {
  const auto found =
      std::find_if(plugins.begin(), plugins.end(), [&](const auto& known) { return known.get() == &plugin; });
  SWARMANOID_EXPECTS(found != plugins.end());
  return found->part;
}

/// A rule and its state.
struct RuleInstance : Named<Rule> {
  bool is_given_up = false;  ///< a call does not return, so success() is not called
};

/// An observer of the run and its state.
struct ObserverInstance : Named<Observer> {
  bool is_finished = false;  ///< finish() was called, or is about to be
  bool is_given_up = false;  ///< a call does not return, so finish(), success() and addMetrics() are not called
};

}  // namespace swarmanoid

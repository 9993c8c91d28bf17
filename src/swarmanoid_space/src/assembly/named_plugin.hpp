/// Plugins as a simulation holds them.
#pragma once

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "swarmanoid_interface/expects.hpp"
#include "swarmanoid_space/observer.hpp"
#include "swarmanoid_space/rule.hpp"

namespace swarmanoid {

/// A plugin, and its description for messages (UserCode::part): "engine 'ground' (dynamics2d)".
template <class Plugin>
struct Named {
  std::shared_ptr<Plugin> plugin;
  std::string part;

  Plugin* get() const { return plugin.get(); }
  Plugin* operator->() const { return plugin.get(); }
  Plugin& operator*() const { return *plugin; }
};

/// The `part` of one of them. @pre it is among them
template <class Plugin>
const std::string& partOf(const std::vector<Named<Plugin>>& plugins, const Plugin& plugin) {
  const auto found =
      std::find_if(plugins.begin(), plugins.end(), [&](const auto& known) { return known.get() == &plugin; });
  SWARMANOID_EXPECTS(found != plugins.end());
  return found->part;
}

/// A rule, and whether it is still to be asked.
struct RuleInstance : Named<Rule> {
  bool is_given_up = false;  ///< a call of it does not return
};

/// An observer of the run, and how far it has come.
struct ObserverInstance : Named<Observer> {
  bool is_finished = false;  ///< or about to be
  bool is_given_up = false;  ///< a call of it does not return
};

}  // namespace swarmanoid

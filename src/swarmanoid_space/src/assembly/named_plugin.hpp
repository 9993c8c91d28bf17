/// Plugins as a simulation holds them.
#pragma once

#include <memory>
#include <string>

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

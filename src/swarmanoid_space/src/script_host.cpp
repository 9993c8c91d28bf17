#include "swarmanoid_space/script_host.hpp"

#include <atomic>

#include "swarmanoid_interface/plugin_library.hpp"
#include "swarmanoid_interface/process/user_code.hpp"

namespace swarmanoid {
namespace {

std::atomic<ScriptHostFactory> registered{nullptr};

}  // namespace

void registerScriptHost(ScriptHostFactory factory) { registered = factory; }

std::shared_ptr<ScriptHost> makeScriptHost(const SourceLocation& location) {
  if (registered == nullptr) {  // a loaded library has registered its factory
    for (const DeclaredLibrary& declared : declaredLibraries()) {
      if (declared.scripts == "python") {
        loadPluginLibrary(declared.library, {}, location);
      }
    }
  }
  const ScriptHostFactory factory = registered;
  if (factory == nullptr) {
    throw ConfigError(location, "source: found python, allowed: cpp alone, because no installed library runs Python");
  }
  try {
    return factory();
  } catch (...) {
    throw ConfigError(location, "source: found python, which does not start: " + describeException());
  }
}

}  // namespace swarmanoid

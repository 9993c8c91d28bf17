/// Checks descriptions of errors from any source: files, services and rules.
///
/// Phase    between ticks.
/// Threads  all functions may be called concurrently once the libraries with kinds are loaded.
#pragma once

#include <string>
#include <vector>

#include "swarmanoid_space/error_models/error_model.hpp"
#include "swarmanoid_space/error_models/error_model_description.hpp"

namespace swarmanoid {

/// Checks an error as far as possible without its device, and fills in the defaults of its kind.
/// @throws ConfigError
void completeError(ErrorModelDescription& error);

/// Returns the attributes of an <error> of that kind.
std::vector<std::string> attributesOfKind(const ErrorKind& kind);

/// @return null if there is no such kind, or it has no such parameter
const Parameter* findErrorParameter(const std::string& kind, const std::string& name);

}  // namespace swarmanoid

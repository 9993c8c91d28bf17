/// Between an engine's parameters and the messages of dynamic_reconfigure.
///
/// Numbers and angles (in degrees) are doubles, integers are integers, everything else is text. Beside the parameters
/// stands the text `last_error`, for the protocol's answer has no place for one: why the last change was refused.
#pragma once

#include <dynamic_reconfigure/Config.h>
#include <dynamic_reconfigure/ConfigDescription.h>

#include <string>
#include <vector>

#include "swarmanoid_space/simulation/simulation.hpp"

namespace swarmanoid {

dynamic_reconfigure::ConfigDescription describe(const std::vector<Parameter>& parameters);

/// @param values of each of the parameters @param last_error "": the last change was made
dynamic_reconfigure::Config toConfig(const std::vector<Parameter>& parameters, const NamedValues& values,
                                     const std::string& last_error);

/// All that the message names, as it would stand in the experiment file; but last_error, which clients send back that
/// set everything.
NamedValues fromConfig(const dynamic_reconfigure::Config& config);

/// What each of the parameters is set to.
NamedValues valuesOf(const std::vector<Parameter>& parameters, const Configuration& configuration);

}  // namespace swarmanoid

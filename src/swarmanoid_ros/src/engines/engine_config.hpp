/// Converts between an engine's parameters and the messages of dynamic_reconfigure.
///
/// Numbers and angles (in degrees) are doubles, integers are integers, everything else is text. The text `last_error`
/// is added to the parameters, because the protocol's answer has no field for it: the reason why the last change was
/// refused.
#pragma once

#include <dynamic_reconfigure/Config.h>
#include <dynamic_reconfigure/ConfigDescription.h>

#include <string>
#include <vector>

#include "swarmanoid_space/simulation/simulation.hpp"

namespace swarmanoid {

dynamic_reconfigure::ConfigDescription describe(const std::vector<Parameter>& parameters);

/// @param values of each of the parameters @param last_error "" if the last change was made
dynamic_reconfigure::Config toConfig(const std::vector<Parameter>& parameters, const NamedValues& values,
                                     const std::string& last_error);

/// Returns all values of the message in the form of the experiment file, except last_error, which clients send back
/// with the other values.
NamedValues fromConfig(const dynamic_reconfigure::Config& config);

/// Returns the values to which the parameters are set.
NamedValues valuesOf(const std::vector<Parameter>& parameters, const Configuration& configuration);

}  // namespace swarmanoid

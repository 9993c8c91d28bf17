/// Values of the parameter server as a Configuration, for readers that know nothing of ROS.
#pragma once

#include <XmlRpcValue.h>

#include <string>

#include "swarmanoid_interface/configuration.hpp"

namespace swarmanoid {

/// Structs become elements, and everything else text: a list is its items separated by commas, as in an experiment
/// file; numbers lose nothing.
/// @param path of the values on the server: what messages name
/// @throws ConfigError if the values are no struct
Configuration configurationFrom(const XmlRpc::XmlRpcValue& values, const std::string& name, const std::string& path);

}  // namespace swarmanoid

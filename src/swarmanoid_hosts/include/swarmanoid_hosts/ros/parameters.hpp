/// Converts values of the parameter server to a Configuration, for readers that do not use ROS.
#pragma once

#include <XmlRpcValue.h>

#include <string>

#include "swarmanoid_interface/configuration.hpp"

namespace swarmanoid {

/// Structs become elements, and all other values become text: a list becomes its items separated by commas, as in an
/// experiment file; numbers keep full precision.
/// @param path of the values on the server, named in messages
/// @throws ConfigError if the values are not a struct
Configuration configurationFrom(const XmlRpc::XmlRpcValue& values, const std::string& name, const std::string& path);

}  // namespace swarmanoid

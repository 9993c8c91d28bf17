/// One <error> of a device in an experiment file, as plain data.
#pragma once

#include <cstdint>
#include <string>

#include "swarmanoid_interface/configuration.hpp"

namespace swarmanoid {

struct ErrorModelDescription {
  std::string kind;               ///< "gaussian", ...
  std::string field;              ///< as the device's descriptor names it; "": every field that the kind suits
  Configuration parameters;       ///< of the kind, defaults filled in; numbers are in the unit of the field
  std::uint64_t from_tick = 0;    ///< the first tick in which it acts
  SourceLocation location;        ///< of the element
  SourceLocation field_location;  ///< the same, or the --set that gave the attribute `field`
};

}  // namespace swarmanoid

/// One <error> of a device in an experiment file, as plain data.
#pragma once

#include <cstdint>
#include <string>

#include "swarmanoid_interface/configuration.hpp"

namespace swarmanoid {

struct ErrorModelDescription {
  std::string kind;               ///< "gaussian", ...
  std::string field;              ///< name in the device's descriptor; "": all fields that suit the kind
  Configuration parameters;       ///< of the kind, including defaults; numbers are in the unit of the field
  std::uint64_t from_tick = 0;    ///< first tick in which the error acts
  SourceLocation location;        ///< of the element
  SourceLocation field_location;  ///< that of the element, or of the --set that gave the attribute `field`

  void archive(StateArchive& state) { state(kind, field, parameters, from_tick, location, field_location); }
};

}  // namespace swarmanoid

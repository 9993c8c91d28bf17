/// Entities asked for by message.
#pragma once

#include <swarmanoid_msgs/EntitySpecification.h>

#include <string>
#include <vector>

#include "swarmanoid_space/experiment.hpp"

namespace swarmanoid {

/// As strict as the experiment file is: unknown type, controller, parameter, value or frame is refused.
/// @param experiment whose controllers may be used
/// @throws std::exception naming what was found and what is allowed
EntityDescription toDescription(const swarmanoid_msgs::EntitySpecification& specification,
                                const Experiment& experiment);

}  // namespace swarmanoid

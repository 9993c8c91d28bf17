/// Converts entities requested by a message.
#pragma once

#include <swarmanoid_msgs/EntitySpecification.h>

#include "swarmanoid_space/experiment/experiment.hpp"

namespace swarmanoid {

/// Converts without validation, which is the task of the space (Simulation::apply).
/// @throws std::exception for another frame, or an invalid colour
EntityDescription toDescription(const swarmanoid_msgs::EntitySpecification& specification);

}  // namespace swarmanoid

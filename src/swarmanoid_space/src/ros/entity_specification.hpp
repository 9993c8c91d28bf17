/// Entities asked for by message.
#pragma once

#include <swarmanoid_msgs/EntitySpecification.h>

#include "swarmanoid_space/experiment_file/experiment.hpp"

namespace swarmanoid {

/// Only translates: the space checks what comes in (Simulation::spawn).
/// @throws std::exception for another frame, or a colour that is none
EntityDescription toDescription(const swarmanoid_msgs::EntitySpecification& specification);

}  // namespace swarmanoid

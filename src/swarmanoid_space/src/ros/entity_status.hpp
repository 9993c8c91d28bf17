/// One entity as a message, with all that its devices say: the answer of the service `inspect`.
#pragma once

#include <swarmanoid_msgs/Inspect.h>

#include "swarmanoid_space/simulation/simulation.hpp"

namespace swarmanoid {

/// Fills what the answer says of the run's clock and, if one was asked for, of the entity.
/// @throws ConfigError if there is no such entity; std::runtime_error if the place is none. The clock is filled then
void inspect(const Simulation& simulation, const swarmanoid_msgs::Inspect::Request& request,
             swarmanoid_msgs::Inspect::Response& answer);

}  // namespace swarmanoid

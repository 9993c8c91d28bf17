/// One entity as a message, with all values of its devices: the answer of the service `inspect`.
#pragma once

#include <swarmanoid_msgs/Inspect.h>

#include "swarmanoid_space/simulation/simulation.hpp"

namespace swarmanoid {

/// Fills in the run's clock and, if the request asks for one, the entity.
/// @throws ConfigError if there is no such entity, std::runtime_error if the requested place is invalid; in both cases
/// the clock is filled in
void inspect(const Simulation& simulation, const swarmanoid_msgs::Inspect::Request& request,
             swarmanoid_msgs::Inspect::Response& answer);

}  // namespace swarmanoid

/// Offers robots to commanders outside this process: participants, and publishers on topics.
#pragma once

#include "world.hpp"

namespace swarmanoid {

/// @throws ConfigError if a device of the robot cannot be transmitted to the source
void refuseUnlessReachable(const RobotInstance& instance, CommandSource source);

/// @throws std::runtime_error if this run has no connection over which other processes could command robots in that way
void refuseUnlessServed(const World& world, CommandSource source);

/// Error for a robot that cannot be commanded in that way. @param location of the request, if it is in a file
ConfigError commandRefusal(const SourceLocation& location, const std::string& robot, CommandSource source,
                           const std::string& why);

/// Updates the offer. It must be called after robots were added, removed, or got another source.
void offerRobots(World& world);

}  // namespace swarmanoid

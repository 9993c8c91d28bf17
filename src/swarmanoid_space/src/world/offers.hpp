/// Which robots are offered to those who command them from elsewhere: participants, and publishers on topics.
#pragma once

#include "world.hpp"

namespace swarmanoid {

/// @throws ConfigError if a device of the robot cannot travel to where the source is
void refuseUnlessReachable(const RobotInstance& instance, CommandSource source);

/// @throws std::runtime_error if no other process reaches this run that could command robots in that way
void refuseUnlessServed(const World& world, CommandSource source);

/// What is told of a robot that cannot be commanded in that way. @param location of what asks for it, if it is in a
/// file
ConfigError commandRefusal(const SourceLocation& location, const std::string& robot, CommandSource source,
                           const std::string& why);

/// To be called when robots have come, gone, or changed their source.
void offerRobots(World& world);

}  // namespace swarmanoid

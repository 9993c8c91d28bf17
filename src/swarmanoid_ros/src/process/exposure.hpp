/// Determines from where this node can be reached over the network. ROS 1 has no authentication: any user who reaches
/// the master or the node's own ports has the rights of the user of this process (docs/explanation/security.md).
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace swarmanoid {

/// Returns the addresses of this machine under which other machines may reach it: those of interfaces that are up,
/// except loopback. The list is empty as well if the system does not report them.
std::vector<std::string> addressesForOthers();

/// Returns whether the name or address means this machine to itself only: localhost, 127.x.x.x, ::1.
bool isLoopback(const std::string& host);

/// Returns a warning for users, or nothing if the machine cannot be reached from others.
/// @param own_host the host name under which the node is registered @param master_host the host of the master
/// @param addresses the result of addressesForOthers
std::optional<std::string> exposureWarning(const std::string& own_host, const std::string& master_host,
                                           const std::vector<std::string>& addresses);

}  // namespace swarmanoid

/// Who can reach this node over the network. ROS 1 asks nobody for a name: whoever reaches the master or the node's own
/// ports may do what its user may do (docs/explanation/security.md).
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace swarmanoid {

/// Addresses of this machine under which others may reach it: those of interfaces that are up, but of no loopback.
/// Empty also where the system does not tell.
std::vector<std::string> addressesForOthers();

/// Whether the name or address means this machine to itself only: localhost, 127.x.x.x, ::1.
bool isLoopback(const std::string& host);

/// What users should know, or nothing if nobody else can reach the machine.
/// @param own_host under which the node is known to others @param master_host where the master is
/// @param addresses as of addressesForOthers
std::optional<std::string> exposureWarning(const std::string& own_host, const std::string& master_host,
                                           const std::vector<std::string>& addresses);

}  // namespace swarmanoid

/// Determines the nodelets that an experiment needs in addition to the space's own, and loads them.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "nodelet_loader.hpp"
#include "swarmanoid_interface/attachment_point.hpp"
#include "swarmanoid_space/simulation/simulation.hpp"

namespace swarmanoid {

/// Returns the requests: an engine nodelet for each engine, a controller nodelet for each controller configuration, an
/// observer nodelet for each robot whose devices have topics.
/// @param commands mailbox for commands that come over the topics
std::vector<AttachmentPoint::Request> partsOf(const Experiment& experiment, const std::vector<std::string>& robots,
                                              const std::shared_ptr<CommandMailbox>& commands);

/// Returns the request for the topics of one robot's devices. @param commands mailbox for commands that come over the
/// topics
AttachmentPoint::Request deviceTopicsOf(const std::string& robot, const std::shared_ptr<CommandMailbox>& commands);

/// Returns <space>/engines/<id>, <space>/controllers/<id>, <robot>/devices.
std::string nodeletName(const std::string& space, const AttachmentPoint::Request& part);

/// Loads the nodelet of one part. @return false if it does not load; the manager's log gives the reason
bool loadPart(NodeletLoader& loader, const std::string& space, const AttachmentPoint::Request& part);

/// Loads a nodelet for each part that is not attached yet, and waits for all.
/// @throws std::runtime_error naming the part that does not load, or is missing after the timeout
void loadParts(NodeletLoader& loader, const std::string& space, AttachmentPoint& point,
               const std::vector<AttachmentPoint::Request>& parts, double timeout_s);

/// Returns the attached parts for the simulation. @pre all are attached
SuppliedParts takeParts(const AttachmentPoint& point, const std::vector<AttachmentPoint::Request>& parts);

}  // namespace swarmanoid

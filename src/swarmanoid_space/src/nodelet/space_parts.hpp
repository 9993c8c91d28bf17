/// The nodelets that an experiment needs beside the space's own: which, and what they bring.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "nodelet_loader.hpp"
#include "swarmanoid_interface/attachment_point.hpp"
#include "swarmanoid_space/simulation/simulation.hpp"

namespace swarmanoid {

/// An engine for each engine, a controller for each controller configuration, an observer for each robot whose
/// devices have topics.
/// @param commands where those put commands that come over topics
std::vector<AttachmentPoint::Request> partsOf(const Experiment& experiment, const std::vector<std::string>& robots,
                                              const std::shared_ptr<CommandMailbox>& commands);

/// The topics of one robot's devices. @param commands where those put commands that come over topics
AttachmentPoint::Request deviceTopicsOf(const std::string& robot, const std::shared_ptr<CommandMailbox>& commands);

/// <space>/engines/<id>, <space>/controllers/<id>, <robot>/devices
std::string nodeletName(const std::string& space, const AttachmentPoint::Request& part);

/// Has the nodelet of one part loaded. @return false if it does not load; the manager's log says why
bool loadPart(NodeletLoader& loader, const std::string& space, const AttachmentPoint::Request& part);

/// Has a nodelet loaded for each part, and waits for all.
/// @throws std::runtime_error naming who does not load, or is missing after the timeout
void loadParts(NodeletLoader& loader, const std::string& space, AttachmentPoint& point,
               const std::vector<AttachmentPoint::Request>& parts, double timeout_s);

/// What has been attached, for the simulation to use. @pre all are there
SuppliedParts takeParts(const AttachmentPoint& point, const std::vector<AttachmentPoint::Request>& parts);

}  // namespace swarmanoid

#include "space_parts.hpp"

#include <ros/names.h>

#include <chrono>

#include "swarmanoid_interface/expects.hpp"

namespace swarmanoid {
namespace {

std::string nodeletType(NodeletLoader& loader, const AttachmentPoint::Request& part) {
  switch (part.kind) {
    case PluginKind::kEngine:
      return "swarmanoid_ros/EngineNodelet";
    case PluginKind::kController:
      return loader.controllerNodelet(part.label);
    default:
      return "swarmanoid_ros/DeviceNodelet";
  }
}

}  // namespace

AttachmentPoint::Request deviceTopicsOf(const std::string& robot, const std::shared_ptr<CommandMailbox>& commands) {
  return {PluginKind::kObserver, robot, "device_topics", {}, commands};
}

std::string nodeletName(const std::string& space, const AttachmentPoint::Request& part) {
  switch (part.kind) {
    case PluginKind::kEngine:
      return space + "/engines/" + part.id;
    case PluginKind::kController:
      return space + "/controllers/" + part.id;
    default:
      // the namespace of a robot is its name, in the parent namespace of the space's node
      return ros::names::parentNamespace(space) == "/"
                 ? "/" + part.id + "/devices"
                 : ros::names::parentNamespace(space) + "/" + part.id + "/devices";
  }
}

bool loadPart(NodeletLoader& loader, const std::string& space, const AttachmentPoint::Request& part) {
  return loader.load(nodeletName(space, part), nodeletType(loader, part), space, part.id);
}

std::vector<AttachmentPoint::Request> partsOf(const Experiment& experiment, const std::vector<std::string>& robots,
                                              const std::shared_ptr<CommandMailbox>& commands) {
  std::vector<AttachmentPoint::Request> parts;
  for (const EngineDescription& engine : experiment.engines) {
    parts.push_back({PluginKind::kEngine, engine.id, engine.label, engine.parameters, nullptr});
  }
  for (const ControllerDescription& controller : experiment.controllers) {
    if (!controller.script.empty()) {
      continue;  // a Python controller is not a nodelet: the space itself runs it
    }
    parts.push_back({PluginKind::kController, controller.id, controller.label, controller.parameters, nullptr});
  }
  for (const std::string& robot : robots) {
    parts.push_back(deviceTopicsOf(robot, commands));
  }
  return parts;
}

void loadParts(NodeletLoader& loader, const std::string& space, AttachmentPoint& point,
               const std::vector<AttachmentPoint::Request>& parts, double timeout_s) {
  const auto load = [&](const AttachmentPoint::Request& part) {
    return loadPart(loader, space, part)
               ? std::string()
               : "the manager cannot load " + nodeletType(loader, part) + "; its log says why";
  };
  for (const AttachmentPoint::Request& part : parts) {
    if (!point.bring(part, load)) {
      break;
    }
  }
  point.waitForAll(std::chrono::milliseconds(static_cast<std::int64_t>(timeout_s * 1000.0)));
}

SuppliedParts takeParts(const AttachmentPoint& point, const std::vector<AttachmentPoint::Request>& parts) {
  SuppliedParts supplied;
  for (const AttachmentPoint::Request& part : parts) {
    const std::shared_ptr<void> held = point.part(part.kind, part.id);
    SWARMANOID_EXPECTS(held != nullptr);
    if (part.kind == PluginKind::kEngine) {
      supplied.engines[part.id] = std::static_pointer_cast<Engine>(held);
    } else if (part.kind == PluginKind::kController) {
      supplied.controllers[part.id] = *std::static_pointer_cast<ControllerFactory>(held);
    }
  }
  return supplied;
}

}  // namespace swarmanoid

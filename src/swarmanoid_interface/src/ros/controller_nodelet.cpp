#include "swarmanoid_interface/ros/controller_nodelet.hpp"

#include <stdexcept>

namespace swarmanoid {

bool ControllerNodelet::runAlone() {
  if (!getPrivateNodeHandle().hasParam("robots")) {
    return false;
  }
  const std::string& name = getName();
  participant_ =
      std::make_unique<Participant>(getPrivateNodeHandle(), name.substr(name.find_first_not_of('/')), label_);
  return true;
}

std::shared_ptr<void> ControllerNodelet::makePart(const AttachmentPoint::Request& request) {
  if (!label_.empty() && label_ != request.label) {
    throw std::runtime_error("this nodelet hosts '" + label_ + "', controller '" + request.id + "' is a '" +
                             request.label + "'");
  }
  const Registry::Entry& entry = Registry::instance().require(PluginKind::kController, request.label);
  return std::make_shared<ControllerFactory>([&entry] { return makePlugin<Controller>(entry); });
}

}  // namespace swarmanoid

#include "swarmanoid_hosts/ros/part_nodelet.hpp"

#include <ros/ros.h>

#include <stdexcept>

#include "swarmanoid_interface/process/user_code.hpp"

namespace swarmanoid {

PartNodelet::~PartNodelet() {
  if (point_ != nullptr) {
    point_->detach(kind_, id_);
  }
}

void PartNodelet::onInit() {
  if (runAlone()) {
    return;
  }
  std::string space;
  getPrivateNodeHandle().getParam("space", space);
  getPrivateNodeHandle().getParam("id", id_);
  try {
    auto point = findAttachmentPoint(space);
    if (point == nullptr) {
      throw std::runtime_error("there is no space '" + space +
                               "' in this process; ~space must name a space nodelet of the same manager");
    }
    try {
      point->attach(kind_, id_, makePart(point->request(kind_, id_)));
      point_ = std::move(point);
    } catch (...) {
      point->refuse(kind_, id_, describeException());
      throw;
    }
  } catch (...) {
    const std::string reason = describeException();
    NODELET_FATAL("%s: %s", getName().c_str(), reason.c_str());
    throw std::runtime_error(reason);  // the manager reports the nodelet as not loaded
  }
}

}  // namespace swarmanoid

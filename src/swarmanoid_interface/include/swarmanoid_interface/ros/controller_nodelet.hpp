/// The nodelet of one controller configuration: it hosts the controllers of all robots that use it.
///
/// swarmanoid_add_controller makes one for each controller, named <package>/<label>. The plain
/// swarmanoid_interface/ControllerNodelet hosts any controller, such as one whose library is only named by a path.
#pragma once

#include "swarmanoid_interface/ros/part_nodelet.hpp"

namespace swarmanoid {

class ControllerNodelet : public PartNodelet {
 public:
  /// @param label of the only controller it hosts; "" for any
  explicit ControllerNodelet(std::string label = "") : PartNodelet(PluginKind::kController), label_(std::move(label)) {}

 private:
  std::shared_ptr<void> makePart(const AttachmentPoint::Request& request) override;

  std::string label_;
};

}  // namespace swarmanoid

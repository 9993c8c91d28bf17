/// The nodelet of one controller configuration: it hosts the controllers of all robots that use it.
///
/// swarmanoid_add_controller makes one for each controller, named `<package>/<label>`. The plain
/// swarmanoid_hosts/ControllerNodelet hosts any controller, such as one whose library is only named by a path.
///
/// With the private parameter `robots` it needs no space in its process. The parameter `provider` selects the source of
/// the robots' devices: `lockstep`, a space elsewhere (participant.hpp), or `topics`, a robot's drivers
/// (robot_host.hpp).
#pragma once

#include <memory>
#include <string>

#include "swarmanoid_hosts/ros/part_nodelet.hpp"

namespace swarmanoid {

class Participant;
class RobotHost;
class UserCodeWatch;

class ControllerNodelet : public PartNodelet {
 public:
  /// @param label of the only controller it hosts; "" for any
  explicit ControllerNodelet(std::string label = "");
  ~ControllerNodelet() override;

 private:
  std::shared_ptr<void> makePart(const AttachmentPoint::Request& request) override;
  bool runAlone() override;

  std::string label_;
  std::unique_ptr<UserCodeWatch> watch_;  ///< for runs without a space in this process; a space has its own watch
  std::unique_ptr<Participant> participant_;
  std::unique_ptr<RobotHost> robot_host_;
};

}  // namespace swarmanoid

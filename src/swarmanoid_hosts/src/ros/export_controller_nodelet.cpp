// Exports swarmanoid_hosts/ControllerNodelet, for controllers that have no nodelet of their own.
#include <pluginlib/class_list_macros.hpp>

#include "swarmanoid_hosts/ros/controller_nodelet.hpp"

namespace swarmanoid {
/// Hosts any controller.
class AnyControllerNodelet final : public ControllerNodelet {};
}  // namespace swarmanoid

PLUGINLIB_EXPORT_CLASS(swarmanoid::AnyControllerNodelet, nodelet::Nodelet)

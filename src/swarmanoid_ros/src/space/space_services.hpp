/// Provides the services of a space: ~pause, ~resume, ~toggle_pause, ~step, ~reset, ~spawn, ~delete, ~move, ~handover,
/// ~set_command_source, ~set_property, ~paint_floor, ~set_fault, ~set_real_time_factor, ~inspect.
///
/// Each service answers when its action is done. Several may be under way at once, so that a pause ends a long step.
#pragma once

#include <ros/node_handle.h>
#include <std_srvs/Trigger.h>
#include <swarmanoid_msgs/Delete.h>
#include <swarmanoid_msgs/Handover.h>
#include <swarmanoid_msgs/Inspect.h>
#include <swarmanoid_msgs/Move.h>
#include <swarmanoid_msgs/PaintFloor.h>
#include <swarmanoid_msgs/Reset.h>
#include <swarmanoid_msgs/SetCommandSource.h>
#include <swarmanoid_msgs/SetFault.h>
#include <swarmanoid_msgs/SetProperty.h>
#include <swarmanoid_msgs/SetRealTimeFactor.h>
#include <swarmanoid_msgs/Spawn.h>
#include <swarmanoid_msgs/Step.h>

#include <vector>

#include "swarmanoid_space/simulation/simulation_thread.hpp"

namespace swarmanoid {

class SpaceServices {
 public:
  /// @param own a handle whose queue is served by several threads
  SpaceServices(ros::NodeHandle own, SimulationThread& thread);

 private:
  bool pause(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response);
  bool resume(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response);
  bool togglePause(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response);
  bool step(swarmanoid_msgs::Step::Request& request, swarmanoid_msgs::Step::Response& response);
  bool reset(swarmanoid_msgs::Reset::Request& request, swarmanoid_msgs::Reset::Response& response);
  bool spawn(swarmanoid_msgs::Spawn::Request& request, swarmanoid_msgs::Spawn::Response& response);
  bool remove(swarmanoid_msgs::Delete::Request& request, swarmanoid_msgs::Delete::Response& response);
  bool move(swarmanoid_msgs::Move::Request& request, swarmanoid_msgs::Move::Response& response);
  bool handover(swarmanoid_msgs::Handover::Request& request, swarmanoid_msgs::Handover::Response& response);
  bool setCommandSource(swarmanoid_msgs::SetCommandSource::Request& request,
                        swarmanoid_msgs::SetCommandSource::Response& response);
  bool setProperty(swarmanoid_msgs::SetProperty::Request& request, swarmanoid_msgs::SetProperty::Response& response);
  bool paintFloor(swarmanoid_msgs::PaintFloor::Request& request, swarmanoid_msgs::PaintFloor::Response& response);
  bool setFault(swarmanoid_msgs::SetFault::Request& request, swarmanoid_msgs::SetFault::Response& response);
  bool setRealTimeFactor(swarmanoid_msgs::SetRealTimeFactor::Request& request,
                         swarmanoid_msgs::SetRealTimeFactor::Response& response);
  bool inspect(swarmanoid_msgs::Inspect::Request& request, swarmanoid_msgs::Inspect::Response& response);

  SimulationThread& thread_;
  std::vector<ros::ServiceServer> servers_;
};

}  // namespace swarmanoid
